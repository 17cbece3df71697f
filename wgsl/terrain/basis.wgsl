// The noise that the land is made of.

#include <math/jet.wgsl>
#include <noise/perlin.wgsl>
#include <noise/simplex.wgsl>
#include <noise/value.wgsl>

/// Which noise: gradient noise (Perlin) is even, simplex noise has no axes to show, value noise is cheaper and blocky.
#option terrain.basis = perlin { value, perlin, simplex }

/// The chosen noise and its gradient: (value, d/dx, d/dy), value -1 .. 1.
fn terrain_noise(p: vec2f, seed: u32) -> vec3f {
#if terrain.basis == perlin
    return perlin_noise2_grad(p, seed);
#elif terrain.basis == simplex
    return simplex_noise2_grad(p, seed);
#else
    return value_noise2_grad(p, seed);
#endif
}

/// The chosen noise with its first and second derivatives.
fn terrain_noise_jet(p: vec2f, seed: u32) -> Jet2 {
#if terrain.basis == perlin
    return perlin_noise2_jet(p, seed);
#elif terrain.basis == simplex
    return simplex_noise2_jet(p, seed);
#else
    return value_noise2_jet(p, seed);
#endif
}
