// The noise that the land is made of.

#include <noise/perlin.wgsl>
#include <noise/value.wgsl>

/// Which noise: gradient noise (Perlin) is even, value noise is cheaper and blocky.
#option terrain.basis = perlin { value, perlin }

/// The chosen noise and its gradient: (value, d/dx, d/dy), value -1 .. 1.
fn terrain_noise(p: vec2f, seed: u32) -> vec3f {
#if terrain.basis == perlin
    return perlin_noise2_grad(p, seed);
#else
    return value_noise2_grad(p, seed);
#endif
}
