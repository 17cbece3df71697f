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

/// The four lattice points around a place in space.
///
/// A body-centred cubic lattice: the integer points, and the middles of their cubes. It is the lattice of Perlin's
/// skewed cubes, turned so that whole numbers carry it onto itself.
struct SimplexTetrahedron {
    /// From each point to the place.
    a: vec3f,
    b: vec3f,
    c: vec3f,
    d: vec3f,
    /// Where the points are: twice their coordinates.
    point_a: vec3i,
    point_b: vec3i,
    point_c: vec3i,
    point_d: vec3i,
}

/// Simplex noise in the plane, -.98786 .. .98786, zero at its lattice points. Variance 0.284.
fn simplex_noise2(p: vec2f, seed: u32) -> f32 {
    return simplex_noise2_grad(p, seed).x;
}

/// Simplex noise in the plane and its analytic gradient: (value, d/dx, d/dy). Value -.98786 .. .98786.
///
/// Lattice gradients are unit vectors of any direction. Continuous up to 4e6 from the origin.
fn simplex_noise2_grad(p: vec2f, seed: u32) -> vec3f {
    let triangle = simplex_triangle(p);
    return simplex_sum2(triangle, triangle.columns, triangle.rows, seed);
}

/// As `simplex_noise2_grad`, repeating every `period` along each axis; any period from 1 to 2^30.
///
/// Triangles of equal sides fit no square. The lattice is stretched along each axis until a whole number of columns and
/// an even number of rows fill the period: by up to 41 % at a period of 1 or 2, by less than 1 / period farther on.
/// The range is that of `simplex_noise2`, slopes grow with the stretch. p and p + period give the same bits.
fn simplex_noise2_tiled(p: vec2f, period: vec2u, seed: u32) -> vec3f {
    let span = clamp(period, vec2u(1u), vec2u(1u << 30u));
    let across = vec2f(span);
    // Columns and rows in a period, less one for each unit: as `simplex_triangle` has them for an endless lattice.
    let columns = span.x + u32(round(0.22474487 * across.x));
    let rows = 2u * max(u32(round(0.70710678 * across.y)), 1u);
    let spare = vec2u(columns, rows) - span;
    let excess = vec2f(spare) / across;
    // Cells are wrapped to -period / 2 .. period / 2, where f32 has its digits.
    let middle = floor(p + 0.5);
    let cell = vec2i(middle);
    let wrapped = vec2u(wrap_cell(cell.x, span.x), wrap_cell(cell.y, span.y));
    let near = bitcast<vec2i>(wrapped - span * vec2u(wrapped > span / 2u));
    // near * spare / span, whole part and remainder: the integers may overflow, their difference does not.
    let whole = vec2i(round(vec2f(near) * excess));
    let rest = vec2f(near * bitcast<vec2i>(spare) - whole * bitcast<vec2i>(span)) / across;
    let t = p - middle;
    let triangle = simplex_triangle_at(near + whole, t + (t * excess + rest));
    let n = simplex_sum2(
        triangle,
        simplex_wrap(triangle.columns, 2u * columns),
        simplex_wrap(triangle.rows, rows),
        seed,
    );
    return n * vec3f(1.0, vec2f(0.81649658, 0.70710678) * (1.0 + excess));
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

/// Simplex noise in space, -.98854 .. .98854, zero at its lattice points. Variance 0.1505.
fn simplex_noise3(p: vec3f, seed: u32) -> f32 {
    return simplex_noise3_grad(p, seed).x;
}

/// Simplex noise in space and its analytic gradient: (value, d/dx, d/dy, d/dz). Value -.98854 .. .98854.
///
/// Lattice gradients are Perlin's twelve edges of the cube. Nothing is skewed, so nothing rounds far from the origin.
fn simplex_noise3_grad(p: vec3f, seed: u32) -> vec4f {
    let lattice = floor(p);
    let corners = simplex_tetrahedron(vec3i(lattice), p - lattice);
    let key = pcg(seed);
    return simplex_corner3(corners.a, simplex_hash3(bitcast<vec3u>(corners.point_a), key))
        + simplex_corner3(corners.b, simplex_hash3(bitcast<vec3u>(corners.point_b), key))
        + simplex_corner3(corners.c, simplex_hash3(bitcast<vec3u>(corners.point_c), key))
        + simplex_corner3(corners.d, simplex_hash3(bitcast<vec3u>(corners.point_d), key));
}

/// As `simplex_noise3_grad`, repeating every `period` along each axis; any period from 1 to 2^30.
///
/// Its lattice repeats with whole numbers, so it is the same noise, unstretched. p and p + period give the same bits.
fn simplex_noise3_tiled(p: vec3f, period: vec3u, seed: u32) -> vec4f {
    let lattice = floor(p);
    let corners = simplex_tetrahedron(vec3i(lattice), p - lattice);
    let twice = 2u * clamp(period, vec3u(1u), vec3u(1u << 30u));
    let key = pcg(seed);
    return simplex_corner3(corners.a, simplex_hash3(simplex_wrap3(corners.point_a, twice), key))
        + simplex_corner3(corners.b, simplex_hash3(simplex_wrap3(corners.point_b, twice), key))
        + simplex_corner3(corners.c, simplex_hash3(simplex_wrap3(corners.point_c, twice), key))
        + simplex_corner3(corners.d, simplex_hash3(simplex_wrap3(corners.point_d, twice), key));
}

/// The noise within a triangle whose points are hashed as `columns` and `rows`.
fn simplex_sum2(triangle: SimplexTriangle, columns: vec3i, rows: vec3i, seed: u32) -> vec3f {
    let key = pcg(seed);
    return simplex_corner2(triangle.a, simplex_hash2(columns.x, rows.x, key))
        + simplex_corner2(triangle.b, simplex_hash2(columns.y, rows.y, key))
        + simplex_corner2(triangle.c, simplex_hash2(columns.z, rows.z, key));
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
    let middle = floor(p + 0.5); // of the cell around p: a small rest keeps its digits
    let cell = vec2i(middle);
    // Steps a unit are (sqrt(3/2), sqrt(2)): 1 + excess. The product's integer bits overflow and leave its fraction.
    let excess = vec2f(0.22474487, 0.41421356);
    let carried = vec2f(bitcast<vec2i>(bitcast<vec2u>(cell) * vec2u(965271873u, 1779033704u))) / 4294967296.0;
    let steps = cell + vec2i(round(vec2f(cell) * excess - carried));
    let t = p - middle;
    return simplex_triangle_at(steps, t + (t * excess + carried));
}

/// The lattice points around a place that is given in steps along x and in rows, whole ones and the rest.
fn simplex_triangle_at(whole: vec2i, rest: vec2f) -> SimplexTriangle {
    let up = floor(rest.y);
    let y = rest.y - up;
    let row = whole.y + i32(up);
    let odd = row & 1;
    // Along the slanted axis of the lattice: which rhombus, and which half of it, its near corner's or its far one's.
    let along = rest.x - 0.5 * f32(odd);
    let slanted = along - 0.5 * y;
    let right = floor(slanted);
    let far = select(0.0, 1.0, slanted - right + y > 1.0);
    let column = 2 * (whole.x + i32(right)) + odd;
    let x = along - right; // straight along the row
    let spacing = vec2f(0.81649658, 0.70710678);
    return SimplexTriangle(
        spacing * vec2f(x - 1.5 * far, y - far),
        spacing * vec2f(x - 1.0, y),
        spacing * vec2f(x - 0.5, y - 1.0),
        vec3i(column) + vec3i(3 * i32(far), 2, 1),
        vec3i(row) + vec3i(i32(far), 0, 1),
    );
}

fn simplex_wrap(indices: vec3i, period: u32) -> vec3i {
    return bitcast<vec3i>(vec3u(
        wrap_cell(indices.x, period),
        wrap_cell(indices.y, period),
        wrap_cell(indices.z, period),
    ));
}

/// What one lattice point adds at `d` from it: (value, d/dx, d/dy, d/dz).
fn simplex_corner3(d: vec3f, hash: u32) -> vec4f {
    let gradient = perlin_direction3(hash);
    let k = max(0.5 - dot(d, d), 0.0);
    let k3 = k * k * k;
    let ramp = dot(gradient, d);
    return 76.0 * k3 * vec4f(k * ramp, k * gradient - 8.0 * ramp * d);
}

/// Hash of a lattice point, given by twice its coordinates. `key`: the hashed seed.
fn simplex_hash3(point: vec3u, key: u32) -> u32 {
    return pcg(point.x + pcg(point.y + pcg(point.z + key)));
}

fn simplex_wrap3(point: vec3i, period: vec3u) -> vec3u {
    return vec3u(wrap_cell(point.x, period.x), wrap_cell(point.y, period.y), wrap_cell(point.z, period.z));
}

/// The lattice points around `cell` + `t`, `t` in 0 .. 1.
fn simplex_tetrahedron(cell: vec3i, t: vec3f) -> SimplexTetrahedron {
    // In the coordinates (y + z, z + x, x + y) the lattice is that of the integers, its simplices are the six parts of
    // each cube by the order of its coordinates: from the low corner along the largest, then the middle, then the last.
    let skewed = t.yzx + t.zxy;
    let low = floor(skewed);
    let inside = skewed - low;
    // The last one strict: of equal coordinates the first counts as larger, so that corners always are four.
    let order = vec3<bool>(inside.x >= inside.y, inside.y >= inside.z, inside.z > inside.x);
    let ahead = select(vec3f(0.0), vec3f(1.0), order);
    let behind = 1.0 - ahead.zxy;
    let one = min(ahead, behind);
    let two = max(ahead, behind);
    let first = simplex_unskew(low);
    let point = 2 * cell + vec3i(first);
    let step_one = simplex_unskew(one);
    let step_two = simplex_unskew(two);
    let from_low = t - 0.5 * first;
    return SimplexTetrahedron(
        from_low,
        from_low - 0.5 * step_one,
        from_low - 0.5 * step_two,
        from_low - 0.5,
        point,
        point + vec3i(step_one),
        point + vec3i(step_two),
        point + 1,
    );
}

/// From skewed coordinates to twice the straight ones.
fn simplex_unskew(skewed: vec3f) -> vec3f {
    return skewed.yzx + skewed.zxy - skewed;
}
