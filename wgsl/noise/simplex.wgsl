// Simplex noise (Perlin 2001; derivatives after Gustavson & McEwan 2022, "Tiling simplex noise and flow noise").
//
// Every lattice point adds (1/2 - r²)^4 times the ramp along its gradient. The kernel ends where the far sides of its
// simplices are, so that nothing cracks at their faces.

#include <math/jet.wgsl>
#include <noise/perlin.wgsl>

/// `simplex_noise2` is nowhere larger: .98786, halfway between two lattice points.
const SIMPLEX_NOISE2_RANGE: f32 = 0.9879;
/// `simplex_noise2` is nowhere steeper: 7.25926, over all unit gradients.
const SIMPLEX_NOISE2_SLOPE: f32 = 7.26;
/// `simplex_noise2` is nowhere more curved, in no direction: 55.1001.
const SIMPLEX_NOISE2_CURVATURE: f32 = 55.11;

/// The three lattice points around a place in the plane.
///
/// Equilateral triangles in rows along x: points sqrt(2/3) apart, rows sqrt(1/2) apart, odd rows half a step on.
struct SimplexTriangle {
    /// From each point to the place.
    a: vec2f,
    b: vec2f,
    c: vec2f,
    /// Where the points are: half steps along x.
    columns: vec3i,
    /// And rows.
    rows: vec3i,
}

/// Simplex noise in the plane, -.98786 .. .98786, zero at its lattice points.
fn simplex_noise2(p: vec2f, seed: u32) -> f32 {
    return simplex_noise2_grad(p, seed).x;
}

/// Simplex noise in the plane and its analytic gradient: (value, d/dx, d/dy). Value -.98786 .. .98786.
///
/// Lattice gradients are unit vectors of any direction.
fn simplex_noise2_grad(p: vec2f, seed: u32) -> vec3f {
    let triangle = simplex_triangle(p);
    let key = pcg(seed);
    return simplex_corner2(triangle.a, simplex_hash2(triangle.columns.x, triangle.rows.x, key))
        + simplex_corner2(triangle.b, simplex_hash2(triangle.columns.y, triangle.rows.y, key))
        + simplex_corner2(triangle.c, simplex_hash2(triangle.columns.z, triangle.rows.z, key));
}

/// As `simplex_noise2_grad`, with the second derivatives; these are continuous too.
fn simplex_noise2_jet(p: vec2f, seed: u32) -> Jet2 {
    let triangle = simplex_triangle(p);
    let key = pcg(seed);
    let hash_a = simplex_hash2(triangle.columns.x, triangle.rows.x, key);
    let hash_b = simplex_hash2(triangle.columns.y, triangle.rows.y, key);
    let hash_c = simplex_hash2(triangle.columns.z, triangle.rows.z, key);
    let first = simplex_corner2(triangle.a, hash_a) + simplex_corner2(triangle.b, hash_b)
        + simplex_corner2(triangle.c, hash_c);
    let second = simplex_corner2_curvature(triangle.a, hash_a) + simplex_corner2_curvature(triangle.b, hash_b)
        + simplex_corner2_curvature(triangle.c, hash_c);
    return Jet2(first.x, first.yz, second);
}

/// What one lattice point adds at `d` from it: (value, d/dx, d/dy).
fn simplex_corner2(d: vec2f, hash: u32) -> vec3f {
    let gradient = perlin_direction2(hash);
    let k = max(0.5 - dot(d, d), 0.0);
    let k3 = k * k * k;
    let ramp = dot(gradient, d);
    return 98.0 * k3 * vec3f(k * ramp, k * gradient - 8.0 * ramp * d);
}

/// What one lattice point adds to the second derivatives: (d²/dx², d²/dxdy, d²/dy²).
fn simplex_corner2_curvature(d: vec2f, hash: u32) -> vec3f {
    let gradient = perlin_direction2(hash);
    let k = max(0.5 - dot(d, d), 0.0);
    let ramp = dot(gradient, d);
    let bend = 48.0 * ramp * vec3f(d.x * d.x, d.x * d.y, d.y * d.y);
    let turn = vec3f(2.0 * gradient.x * d.x + ramp, gradient.x * d.y + gradient.y * d.x, 2.0 * gradient.y * d.y + ramp);
    return 98.0 * k * k * (bend - 8.0 * k * turn);
}

/// Hash of a lattice point. `key`: the hashed seed.
fn simplex_hash2(column: i32, row: i32, key: u32) -> u32 {
    return pcg(bitcast<u32>(column) + pcg(bitcast<u32>(row) + key));
}

/// The lattice points around `p`.
///
/// Carried to the lattice as cell + fraction, the cell's part in 32-bit fixed point: nothing cancels far out.
fn simplex_triangle(p: vec2f) -> SimplexTriangle {
    let floored = floor(p);
    let cell = vec2i(floored);
    // Steps a unit are (sqrt(3/2), sqrt(2)): 1 + excess. The product's integer bits overflow and leave its fraction.
    let excess = vec2f(0.22474487, 0.41421356);
    let carried = vec2f(bitcast<vec2i>(bitcast<vec2u>(cell) * vec2u(965271873u, 1779033704u))) / 4294967296.0;
    let steps = cell + vec2i(round(vec2f(cell) * excess - carried));
    return simplex_triangle_at(steps, (p - floored) * (1.0 + excess) + carried);
}

/// The lattice points around a place that is given in steps along x and in rows, whole ones and the rest.
fn simplex_triangle_at(whole: vec2i, rest: vec2f) -> SimplexTriangle {
    let up = floor(rest.y);
    let y = rest.y - up;
    let row = whole.y + i32(up);
    let odd = row & 1;
    // Along the slanted axes of the lattice.
    let slanted = rest.x - 0.5 * (y + f32(odd));
    let right = floor(slanted);
    let x = slanted - right;
    let column = 2 * (whole.x + i32(right)) + odd;
    let far = select(0.0, 1.0, x + y > 1.0); // which half of the rhombus: its near corner or its far one
    let spacing = vec2f(0.81649658, 0.70710678);
    return SimplexTriangle(
        spacing * vec2f(x - far + 0.5 * (y - far), y - far),
        spacing * vec2f(x - 1.0 + 0.5 * y, y),
        spacing * vec2f(x + 0.5 * (y - 1.0), y - 1.0),
        vec3i(column) + vec3i(3 * i32(far), 2, 1),
        vec3i(row) + vec3i(i32(far), 0, 1),
    );
}
