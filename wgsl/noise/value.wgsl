// Value noise: random values on the integer lattice, blended with the quintic fade. Twice continuously differentiable.

#include <math/fade.wgsl>
#include <math/jet.wgsl>
#include <noise/lattice.wgsl>

/// `value_noise2` is nowhere larger.
const VALUE_NOISE2_RANGE: f32 = 1.0;
/// `value_noise2` is nowhere steeper: 2 * 1.875, where lattice values alternate from column to column.
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
    return value_blend2(cell_hash2(vec2i(lattice), seed), p - lattice);
}

/// As `value_noise2_grad`, repeating every `period` cells along each axis; any period from 1 on.
///
/// Cells are wrapped, not positions: p and p + period give the same bits.
fn value_noise2_tiled(p: vec2f, period: vec2u, seed: u32) -> vec3f {
    let lattice = floor(p);
    return value_blend2(cell_hash2_tiled(vec2i(lattice), period, seed), p - lattice);
}

/// As `value_noise2_grad`, with the second derivatives; these are continuous too.
fn value_noise2_jet(p: vec2f, seed: u32) -> Jet2 {
    let lattice = floor(p);
    let t = p - lattice;
    let v = signed_float4(cell_hash2(vec2i(lattice), seed));
    let w = quintic_fade2(t);
    let dw = quintic_fade2_slope(t);
    let ddw = quintic_fade2_curvature(t);
    let along_y = mix(v.xy, v.zw, w.y);
    let rise = vec2f(along_y.y - along_y.x, mix(v.z - v.x, v.w - v.y, w.x));
    let twist = (v.w - v.z) - (v.y - v.x);
    return Jet2(
        mix(along_y.x, along_y.y, w.x),
        dw * rise,
        vec3f(ddw.x * rise.x, dw.x * dw.y * twist, ddw.y * rise.y),
    );
}

/// Value noise in space, -1 .. 1. Variance 0.16035.
fn value_noise3(p: vec3f, seed: u32) -> f32 {
    return value_noise3_grad(p, seed).x;
}

/// Value noise in space and its analytic gradient: (value, d/dx, d/dy, d/dz). Value -1 .. 1, derivatives at most 3.75.
fn value_noise3_grad(p: vec3f, seed: u32) -> vec4f {
    let lattice = floor(p);
    return value_blend3(cell_hash3(vec3i(lattice), seed), p - lattice);
}

/// As `value_noise3_grad`, repeating every `period` cells along each axis; any period from 1 on.
fn value_noise3_tiled(p: vec3f, period: vec3u, seed: u32) -> vec4f {
    let lattice = floor(p);
    return value_blend3(cell_hash3_tiled(vec3i(lattice), period, seed), p - lattice);
}

/// (value, gradient) at `t` of a cell, of its corners' hashes.
fn value_blend2(corners: vec4u, t: vec2f) -> vec3f {
    let v = signed_float4(corners);
    let w = quintic_fade2(t);
    let dw = quintic_fade2_slope(t);
    let along_y = mix(v.xy, v.zw, w.y);
    return vec3f(
        mix(along_y.x, along_y.y, w.x),
        dw.x * (along_y.y - along_y.x),
        dw.y * mix(v.z - v.x, v.w - v.y, w.x),
    );
}

/// As `value_blend2`, in space.
fn value_blend3(corners: CellHash3, t: vec3f) -> vec4f {
    let near = signed_float4(corners.near);
    let far = signed_float4(corners.far);
    let w = quintic_fade3(t);
    let dw = quintic_fade3_slope(t);
    let v = mix(near, far, w.z);
    let along_y = mix(v.xy, v.zw, w.y);
    let rise_z = far - near;
    let rise_z_along_y = mix(rise_z.xy, rise_z.zw, w.y);
    return vec4f(
        mix(along_y.x, along_y.y, w.x),
        dw.x * (along_y.y - along_y.x),
        dw.y * mix(v.z - v.x, v.w - v.y, w.x),
        dw.z * mix(rise_z_along_y.x, rise_z_along_y.y, w.x),
    );
}
