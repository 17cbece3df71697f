// Gradient noise (Perlin 2002, "Improving Noise"), scaled to -1 .. 1.

#include <math/fade.wgsl>
#include <math/jet.wgsl>
#include <noise/lattice.wgsl>

/// `perlin_noise2` is nowhere larger: four unit gradients that point at the middle of their cell.
const PERLIN_NOISE2_RANGE: f32 = 1.0;
/// `perlin_noise2` is nowhere steeper: 2.92615 in the middle of a cell, over all unit gradients.
const PERLIN_NOISE2_SLOPE: f32 = 2.9262;
/// `perlin_noise2` is nowhere more curved, in no direction: 13.06075 at (.3555, .6445) of a cell, along its diagonal.
const PERLIN_NOISE2_CURVATURE: f32 = 13.061;
/// `perlin_noise3` is nowhere steeper: 3.616875 in the middle of a cell, along an axis.
const PERLIN_NOISE3_SLOPE: f32 = 3.6169;

/// Gradient noise in the plane, -1 .. 1, zero on the lattice. Standard deviation 0.304.
fn perlin_noise2(p: vec2f, seed: u32) -> f32 {
    return perlin_noise2_grad(p, seed).x;
}

/// Gradient noise in the plane and its analytic gradient: (value, d/dx, d/dy). Value -1 .. 1.
///
/// Lattice gradients are unit vectors of any direction, not of the usual eight: landscapes show the difference.
/// The raw supremum is then 1/sqrt(2), at the middle of a cell whose four gradients point at it.
fn perlin_noise2_grad(p: vec2f, seed: u32) -> vec3f {
    let lattice = floor(p);
    return perlin_blend2(cell_hash2(vec2i(lattice), seed), p - lattice);
}

/// `perlin_noise2_grad` at `cell` + `fraction`: as smooth a million cells from the origin as beside it.
///
/// `fraction` may leave 0 .. 1; what is whole of it is carried to the cell. Equal to `perlin_noise2_grad(p, seed)` bit
/// for bit at `cell` = floor(p), `fraction` = fract(p).
fn perlin_noise2_at_grad(cell: vec2i, fraction: vec2f, seed: u32) -> vec3f {
    let carry = floor(fraction);
    return perlin_blend2(cell_hash2(cell + vec2i(carry), seed), fraction - carry);
}

/// As `perlin_noise2_grad`, repeating every `period` cells along each axis; any period from 1 on.
///
/// Cells are wrapped, not positions: p and p + period give the same bits.
fn perlin_noise2_tiled(p: vec2f, period: vec2u, seed: u32) -> vec3f {
    let lattice = floor(p);
    return perlin_blend2(cell_hash2_tiled(vec2i(lattice), period, seed), p - lattice);
}

/// As `perlin_noise2_grad`, with the second derivatives; these are continuous too.
fn perlin_noise2_jet(p: vec2f, seed: u32) -> Jet2 {
    let lattice = floor(p);
    let t = p - lattice;
    let corners = cell_hash2(vec2i(lattice), seed);
    let g00 = perlin_direction2(corners.x);
    let g10 = perlin_direction2(corners.y);
    let g01 = perlin_direction2(corners.z);
    let g11 = perlin_direction2(corners.w);
    let v00 = dot(g00, t);
    let v10 = dot(g10, t - vec2f(1.0, 0.0));
    let v01 = dot(g01, t - vec2f(0.0, 1.0));
    let v11 = dot(g11, t - vec2f(1.0, 1.0));
    let w = quintic_fade2(t);
    let dw = quintic_fade2_slope(t);
    let ddw = quintic_fade2_curvature(t);
    let low = mix(v00, v10, w.x);
    let high = mix(v01, v11, w.x);
    let rise = vec2f(mix(v10 - v00, v11 - v01, w.y), high - low);
    let twist = (v11 - v01) - (v10 - v00);
    let g0 = mix(g00, g10, w.x);
    let g1 = mix(g01, g11, w.x);
    // How the blended lattice gradient changes along x and along y, before the fade's own slope.
    let g_x = mix(g10 - g00, g11 - g01, w.y);
    let g_y = g1 - g0;
    let hessian = vec3f(
        2.0 * dw.x * g_x.x + ddw.x * rise.x,
        dw.x * g_x.y + dw.y * g_y.x + dw.x * dw.y * twist,
        2.0 * dw.y * g_y.y + ddw.y * rise.y,
    );
    return Jet2(1.4142 * mix(low, high, w.y), 1.4142 * (mix(g0, g1, w.y) + dw * rise), 1.4142 * hessian);
}

/// Gradient noise in space, -1 .. 1, zero on the lattice. Standard deviation 0.26.
fn perlin_noise3(p: vec3f, seed: u32) -> f32 {
    return perlin_noise3_grad(p, seed).x;
}

/// Gradient noise in space and its analytic gradient: (value, d/dx, d/dy, d/dz). Value -1 .. 1.
///
/// Lattice gradients are Perlin's twelve edges of the cube; the raw supremum is 1.0363538.
fn perlin_noise3_grad(p: vec3f, seed: u32) -> vec4f {
    let lattice = floor(p);
    return perlin_blend3(cell_hash3(vec3i(lattice), seed), p - lattice);
}

/// As `perlin_noise3_grad`, repeating every `period` cells along each axis; any period from 1 on.
fn perlin_noise3_tiled(p: vec3f, period: vec3u, seed: u32) -> vec4f {
    let lattice = floor(p);
    return perlin_blend3(cell_hash3_tiled(vec3i(lattice), period, seed), p - lattice);
}

/// `perlin_noise3` at `cell` + `fraction`: as smooth a million cells from the origin as beside it.
///
/// `fraction` may leave 0 .. 1; what is whole of it is carried to the cell. Equal to `perlin_noise3(p, seed)` bit for
/// bit at `cell` = floor(p), `fraction` = fract(p).
fn perlin_noise3_at(cell: vec3i, fraction: vec3f, seed: u32) -> f32 {
    return perlin_noise3_at_grad(cell, fraction, seed).x;
}

/// `perlin_noise3_at` and its analytic gradient: (value, d/dx, d/dy, d/dz).
fn perlin_noise3_at_grad(cell: vec3i, fraction: vec3f, seed: u32) -> vec4f {
    let carry = floor(fraction);
    return perlin_blend3(cell_hash3(cell + vec3i(carry), seed), fraction - carry);
}

/// (value, gradient) at `t` of a cell, of its corners' hashes.
fn perlin_blend2(corners: vec4u, t: vec2f) -> vec3f {
    let g00 = perlin_direction2(corners.x);
    let g10 = perlin_direction2(corners.y);
    let g01 = perlin_direction2(corners.z);
    let g11 = perlin_direction2(corners.w);
    let v00 = dot(g00, t);
    let v10 = dot(g10, t - vec2f(1.0, 0.0));
    let v01 = dot(g01, t - vec2f(0.0, 1.0));
    let v11 = dot(g11, t - vec2f(1.0, 1.0));
    let w = quintic_fade2(t);
    let dw = quintic_fade2_slope(t);
    let low = mix(v00, v10, w.x);
    let high = mix(v01, v11, w.x);
    let carried = mix(mix(g00, g10, w.x), mix(g01, g11, w.x), w.y);
    let blended = dw * vec2f(mix(v10 - v00, v11 - v01, w.y), high - low);
    return 1.4142 * vec3f(mix(low, high, w.y), carried + blended);
}

/// As `perlin_blend2`, in space.
fn perlin_blend3(corners: CellHash3, t: vec3f) -> vec4f {
    // Each corner as (value, gradient): blending them blends both.
    let c000 = perlin_corner3(corners.near.x, t);
    let c100 = perlin_corner3(corners.near.y, t - vec3f(1.0, 0.0, 0.0));
    let c010 = perlin_corner3(corners.near.z, t - vec3f(0.0, 1.0, 0.0));
    let c110 = perlin_corner3(corners.near.w, t - vec3f(1.0, 1.0, 0.0));
    let c001 = perlin_corner3(corners.far.x, t - vec3f(0.0, 0.0, 1.0));
    let c101 = perlin_corner3(corners.far.y, t - vec3f(1.0, 0.0, 1.0));
    let c011 = perlin_corner3(corners.far.z, t - vec3f(0.0, 1.0, 1.0));
    let c111 = perlin_corner3(corners.far.w, t - vec3f(1.0, 1.0, 1.0));
    let w = quintic_fade3(t);
    let dw = quintic_fade3_slope(t);
    let x00 = mix(c000, c100, w.x);
    let x10 = mix(c010, c110, w.x);
    let x01 = mix(c001, c101, w.x);
    let x11 = mix(c011, c111, w.x);
    let y0 = mix(x00, x10, w.y);
    let y1 = mix(x01, x11, w.y);
    let blended = dw * vec3f(
        mix(mix(c100.x - c000.x, c110.x - c010.x, w.y), mix(c101.x - c001.x, c111.x - c011.x, w.y), w.z),
        mix(x10.x - x00.x, x11.x - x01.x, w.z),
        y1.x - y0.x,
    );
    return 0.9645 * (mix(y0, y1, w.z) + vec4f(0.0, blended));
}

/// The ramp of one lattice point, `d` from it: (value, gradient).
fn perlin_corner3(hash: u32, d: vec3f) -> vec4f {
    let gradient = perlin_direction3(hash);
    return vec4f(dot(gradient, d), gradient);
}

/// A unit vector from the hash of a lattice point, near enough uniform over the circle (density within 1 %).
///
/// Half-angle form of the circle: no sine, so the same on every GPU.
fn perlin_direction2(bits: u32) -> vec2f {
    let u = signed_float(bits << 1u); // the top bit chooses the half of the circle
    let u2 = u * u;
    let t = u * (0.78540 + u2 * (0.16149 + u2 * 0.05311)); // tan(u pi / 4)
    let scale = select(1.0, -1.0, bits >= 0x80000000u) / (1.0 + t * t);
    return vec2f((1.0 - t * t) * scale, 2.0 * t * scale);
}

/// One of the twelve edge midpoints of the cube with corners at +-1; four of them come up twice as often (Perlin
/// 2002).
fn perlin_direction3(bits: u32) -> vec3f {
    let h = bits >> 28u;
    let a = select(1.0, -1.0, (h & 1u) != 0u);
    let b = select(1.0, -1.0, (h & 2u) != 0u);
    if h < 4u {
        return vec3f(a, b, 0.0);
    }
    if h < 8u {
        return vec3f(a, 0.0, b);
    }
    if h < 12u || h == 13u || h == 15u {
        return vec3f(0.0, a, b);
    }
    return vec3f(b, a, 0.0); // 12 and 14
}
