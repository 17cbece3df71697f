// Curl noise (Bridson 2007, "Curl-Noise for Procedural Fluid Flow"): flows without sources or sinks.
//
// The divergence of a curl is zero whatever the potential, and the derivatives here are analytic: rounding is all that
// is left of it.

#include <noise/perlin.wgsl>

/// Flow in the plane around the hills of `perlin_noise2`: its gradient, turned clockwise by a right angle. Divergence
/// zero; no longer than `PERLIN_NOISE2_SLOPE`.
fn curl_noise2(p: vec2f, seed: u32) -> vec2f {
    let slope = perlin_noise2_grad(p, seed).yz;
    return vec2f(slope.y, -slope.x);
}

/// Flow in space: the curl of three Perlin noises. Divergence zero; each component within -7.24 .. 7.24.
fn curl_noise3(p: vec3f, seed: u32) -> vec3f {
    let key = pcg(seed);
    var flow = vec3f(0.0);
    for (var i = 0u; i < 3u; i++) {
        let axis = select(vec3f(0.0), vec3f(1.0), vec3u(0u, 1u, 2u) == vec3u(i));
        flow += cross(perlin_noise3_grad(p, key + i).yzw, axis); // the curl of noise times a constant vector
    }
    return flow;
}
