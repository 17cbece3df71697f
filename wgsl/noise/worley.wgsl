// Cellular noise (Worley 1996): distances to the nearest of feature points, one anywhere in each cell of a grid.
//
// 1 - f1 / sqrt(dimension) is the inverted form, 0 .. 1 and 1 at the feature points: the billows of clouds. f2 - f1 is
// zero on the borders between regions.

#include <noise/lattice.wgsl>

/// What `worley_noise2` finds.
struct Worley2 {
    /// Distance to the nearest feature point, 0 .. sqrt(2). Mean .4294.
    f1: f32,
    /// Distance to the second nearest, `f1` .. 1.59. Mean .699.
    f2: f32,
    /// From the place to the nearest feature point; -offset / f1 is the gradient of `f1`.
    offset: vec2f,
    /// Hash of the nearest point's cell: the same all over its region, another one in the next.
    id: u32,
    /// The nearest point's cell, not wrapped.
    cell: vec2i,
}

/// What `worley_noise3` finds.
struct Worley3 {
    /// Distance to the nearest feature point, 0 .. sqrt(3). Mean .52.
    f1: f32,
    /// Distance to the second nearest, `f1` .. sqrt(3). Mean .7163.
    f2: f32,
    /// From the place to the nearest feature point; -offset / f1 is the gradient of `f1`.
    offset: vec3f,
    /// Hash of the nearest point's cell: the same all over its region, another one in the next.
    id: u32,
    /// The nearest point's cell, not wrapped.
    cell: vec3i,
}

/// The two feature points nearest to `p` in the plane, exactly: 9 cells are searched, and where the second distance
/// found is over 1, the sides of the next ring that it reaches.
fn worley_noise2(p: vec2f, seed: u32) -> Worley2 {
    return worley_search2(p, vec2u(0u), seed);
}

/// As `worley_noise2`, repeating every `period` cells along each axis; any period from 1 on.
///
/// Cells are wrapped, not positions: p and p + period give the same bits (but for `cell`).
fn worley_noise2_tiled(p: vec2f, period: vec2u, seed: u32) -> Worley2 {
    return worley_search2(p, max(period, vec2u(1u)), seed);
}

/// The two feature points nearest to `p` in space, exactly: 27 cells are searched, and where the second distance
/// found is over 1, the sides of the next ring that it reaches.
fn worley_noise3(p: vec3f, seed: u32) -> Worley3 {
    return worley_search3(p, vec3u(0u), seed);
}

/// As `worley_noise3`, repeating every `period` cells along each axis; any period from 1 on.
///
/// Cells are wrapped, not positions: p and p + period give the same bits (but for `cell`).
fn worley_noise3_tiled(p: vec3f, period: vec3u, seed: u32) -> Worley3 {
    return worley_search3(p, max(period, vec3u(1u)), seed);
}

/// A period of 0 is no period.
fn worley_search2(p: vec2f, period: vec2u, seed: u32) -> Worley2 {
    let lattice = floor(p);
    let t = p - lattice;
    let home = vec2i(lattice);
    let key = pcg(seed);
    // Squares of distances until the end.
    var found = Worley2(1e9, 1e9, vec2f(0.0), 0u, vec2i(0));
    for (var j = -1; j <= 1; j++) {
        let row = pcg(worley_wrap(home.y + j, period.y) + key);
        found = worley_visit2(found, t, vec2i(-1, j), pcg(worley_wrap(home.x - 1, period.x) + row));
        found = worley_visit2(found, t, vec2i(0, j), pcg(worley_wrap(home.x, period.x) + row));
        found = worley_visit2(found, t, vec2i(1, j), pcg(worley_wrap(home.x + 1, period.x) + row));
    }
    // What lies beyond is at least 1 away. The next ring's far side is at least 2 away, farther than any second point.
    if found.f2 > 1.0 {
        let low = vec2i(-1) - vec2i((1.0 + t) * (1.0 + t) < vec2f(found.f2));
        let high = vec2i(1) + vec2i((2.0 - t) * (2.0 - t) < vec2f(found.f2));
        for (var j = low.y; j <= high.y; j++) {
            let row = pcg(worley_wrap(home.y + j, period.y) + key);
            let searched = abs(j) < 2; // in this row only the ends are new
            for (var i = select(low.x, -2, searched); i <= high.x; i += select(1, 4, searched)) {
                if i >= low.x {
                    found = worley_visit2(found, t, vec2i(i, j), pcg(worley_wrap(home.x + i, period.x) + row));
                }
            }
        }
    }
    found.f1 = sqrt(found.f1);
    found.f2 = sqrt(found.f2);
    found.cell += home;
    return found;
}

fn worley_search3(p: vec3f, period: vec3u, seed: u32) -> Worley3 {
    let lattice = floor(p);
    let t = p - lattice;
    let home = vec3i(lattice);
    let key = pcg(seed);
    var found = Worley3(1e9, 1e9, vec3f(0.0), 0u, vec3i(0));
    for (var k = -1; k <= 1; k++) {
        let slice = pcg(worley_wrap(home.z + k, period.z) + key);
        for (var j = -1; j <= 1; j++) {
            let row = pcg(worley_wrap(home.y + j, period.y) + slice);
            found = worley_visit3(found, t, vec3i(-1, j, k), pcg(worley_wrap(home.x - 1, period.x) + row));
            found = worley_visit3(found, t, vec3i(0, j, k), pcg(worley_wrap(home.x, period.x) + row));
            found = worley_visit3(found, t, vec3i(1, j, k), pcg(worley_wrap(home.x + 1, period.x) + row));
        }
    }
    if found.f2 > 1.0 {
        let low = vec3i(-1) - vec3i((1.0 + t) * (1.0 + t) < vec3f(found.f2));
        let high = vec3i(1) + vec3i((2.0 - t) * (2.0 - t) < vec3f(found.f2));
        for (var k = low.z; k <= high.z; k++) {
            let slice = pcg(worley_wrap(home.z + k, period.z) + key);
            for (var j = low.y; j <= high.y; j++) {
                let row = pcg(worley_wrap(home.y + j, period.y) + slice);
                let searched = max(abs(j), abs(k)) < 2;
                for (var i = select(low.x, -2, searched); i <= high.x; i += select(1, 4, searched)) {
                    if i >= low.x {
                        let id = pcg(worley_wrap(home.x + i, period.x) + row);
                        found = worley_visit3(found, t, vec3i(i, j, k), id);
                    }
                }
            }
        }
    }
    found.f1 = sqrt(found.f1);
    found.f2 = sqrt(found.f2);
    found.cell += home;
    return found;
}

/// `found` after a look at the cell `step` away, whose hash is `id`. Distances are squares here.
fn worley_visit2(found: Worley2, t: vec2f, step: vec2i, id: u32) -> Worley2 {
    let offset = vec2f(step) - t + unit_float2(vec2u(id, pcg(id)));
    let square = dot(offset, offset);
    if square < found.f1 {
        return Worley2(square, found.f1, offset, id, step);
    }
    return Worley2(found.f1, min(found.f2, square), found.offset, found.id, found.cell);
}

/// As `worley_visit2`, in space.
fn worley_visit3(found: Worley3, t: vec3f, step: vec3i, id: u32) -> Worley3 {
    let next = pcg(id);
    let offset = vec3f(step) - t + unit_float3(vec3u(id, next, pcg(next)));
    let square = dot(offset, offset);
    if square < found.f1 {
        return Worley3(square, found.f1, offset, id, step);
    }
    return Worley3(found.f1, min(found.f2, square), found.offset, found.id, found.cell);
}

/// `wrap_cell`, or no wrapping at all if `period` is 0.
fn worley_wrap(cell: i32, period: u32) -> u32 {
    if period == 0u {
        return bitcast<u32>(cell);
    }
    return wrap_cell(cell, period);
}
