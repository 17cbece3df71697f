// Value noise: random values on the integer lattice, blended with the quintic fade. Twice continuously differentiable.

#include <math/fade.wgsl>
#include <math/jet.wgsl>
#include <noise/pcg.wgsl>

/// `value_noise2` is nowhere larger.
const VALUE_NOISE2_RANGE: f32 = 1.0;
/// `value_noise2` is nowhere steeper: 2 * 1.875, lattice values alternating between columns.
const VALUE_NOISE2_SLOPE: f32 = 3.7501;
/// `value_noise2` is nowhere more curved, in no direction: 4 * 1.875^2, in the middle of a saddle.
const VALUE_NOISE2_CURVATURE: f32 = 14.063;

/// Value noise in the plane, -1 .. 1 (a blend of lattice values in that range). Variance 0.20465.
fn value_noise2(p: vec2f, seed: u32) -> f32 {
    return value_noise2_grad(p, seed).x;
}

/// Value noise in the plane and its analytic gradient: (value, d/dx, d/dy). Value -1 .. 1, |d/dx|, |d/dy| <= 3.75.
fn value_noise2_grad(p: vec2f, seed: u32) -> vec3f {
    let lattice = floor(p);
    let t = p - lattice;
    let cell = bitcast<vec2u>(vec2i(lattice));
    let key = pcg(seed);
    let row0 = pcg(cell.y + key);
    let row1 = pcg(cell.y + 1u + key);
    let v00 = signed_float(pcg(cell.x + row0));
    let v10 = signed_float(pcg(cell.x + 1u + row0));
    let v01 = signed_float(pcg(cell.x + row1));
    let v11 = signed_float(pcg(cell.x + 1u + row1));
    let w = quintic_fade2(t);
    let dw = quintic_fade2_slope(t);
    let low = mix(v00, v10, w.x);
    let high = mix(v01, v11, w.x);
    return vec3f(mix(low, high, w.y), dw.x * mix(v10 - v00, v11 - v01, w.y), dw.y * (high - low));
}

/// As `value_noise2_grad`, with the second derivatives; these are continuous too.
fn value_noise2_jet(p: vec2f, seed: u32) -> Jet2 {
    let lattice = floor(p);
    let t = p - lattice;
    let cell = bitcast<vec2u>(vec2i(lattice));
    let key = pcg(seed);
    let row0 = pcg(cell.y + key);
    let row1 = pcg(cell.y + 1u + key);
    let v00 = signed_float(pcg(cell.x + row0));
    let v10 = signed_float(pcg(cell.x + 1u + row0));
    let v01 = signed_float(pcg(cell.x + row1));
    let v11 = signed_float(pcg(cell.x + 1u + row1));
    let w = quintic_fade2(t);
    let dw = quintic_fade2_slope(t);
    let ddw = quintic_fade2_curvature(t);
    let low = mix(v00, v10, w.x);
    let high = mix(v01, v11, w.x);
    let rise = vec2f(mix(v10 - v00, v11 - v01, w.y), high - low);
    let twist = (v11 - v01) - (v10 - v00);
    return Jet2(mix(low, high, w.y), dw * rise, vec3f(ddw.x * rise.x, dw.x * dw.y * twist, ddw.y * rise.y));
}

/// Value noise in space, -1 .. 1. Variance 0.16035.
fn value_noise3(p: vec3f, seed: u32) -> f32 {
    return value_noise3_grad(p, seed).x;
}

/// Value noise in space and its analytic gradient: (value, d/dx, d/dy, d/dz). Value -1 .. 1, derivatives at most 3.75.
fn value_noise3_grad(p: vec3f, seed: u32) -> vec4f {
    let lattice = floor(p);
    let t = p - lattice;
    let cell = bitcast<vec3u>(vec3i(lattice));
    let key = pcg(seed);
    let slice = vec2u(pcg(cell.z + key), pcg(cell.z + 1u + key));
    let row0 = vec2u(pcg(cell.y + slice.x), pcg(cell.y + slice.y)); // at y, for the near and the far slice
    let row1 = vec2u(pcg(cell.y + 1u + slice.x), pcg(cell.y + 1u + slice.y));
    // Corners by (x, y), each with its near and its far value.
    let v00 = vec2f(signed_float(pcg(cell.x + row0.x)), signed_float(pcg(cell.x + row0.y)));
    let v10 = vec2f(signed_float(pcg(cell.x + 1u + row0.x)), signed_float(pcg(cell.x + 1u + row0.y)));
    let v01 = vec2f(signed_float(pcg(cell.x + row1.x)), signed_float(pcg(cell.x + row1.y)));
    let v11 = vec2f(signed_float(pcg(cell.x + 1u + row1.x)), signed_float(pcg(cell.x + 1u + row1.y)));
    let w = quintic_fade3(t);
    let dw = quintic_fade3_slope(t);
    let low = mix(v00, v10, w.x);
    let high = mix(v01, v11, w.x);
    let value = mix(low, high, w.y);
    let along_x = mix(v10 - v00, v11 - v01, w.y);
    let along_y = high - low;
    return vec4f(
        mix(value.x, value.y, w.z),
        dw.x * mix(along_x.x, along_x.y, w.z),
        dw.y * mix(along_y.x, along_y.y, w.z),
        dw.z * (value.y - value.x),
    );
}
