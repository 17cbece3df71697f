// Hashes of the corners of a cell of the integer lattice, endless or repeating: what lattice noises are made of.
//
// Hashes nest, h(x + h(y + h(z + h(seed)))), so that corners of one row share the inner ones.

#include <noise/pcg.wgsl>

/// Hashes of the eight corners of a cell in space.
struct CellHash3 {
    /// At (0, 0), (1, 0), (0, 1) and (1, 1) of the face toward -z.
    near: vec4u,
    /// The same corners of the face toward +z.
    far: vec4u,
}

/// `cell` folded into 0 .. `period` - 1, also where it is negative. A `period` of 0 counts as 1.
fn wrap_cell(cell: i32, period: u32) -> u32 {
    let modulus = max(period, 1u);
    // ~cell is -1 - cell: the cells below zero count down from the period's end.
    let folded = bitcast<u32>(select(~cell, cell, cell >= 0)) % modulus;
    return select(modulus - 1u - folded, folded, cell >= 0);
}

/// The cell after a wrapped one.
fn wrap_next(wrapped: u32, period: u32) -> u32 {
    return select(wrapped + 1u, 0u, wrapped + 1u >= period);
}

/// Hashes of the corners of `cell` at (0, 0), (1, 0), (0, 1) and (1, 1).
fn cell_hash2(cell: vec2i, seed: u32) -> vec4u {
    let low = bitcast<vec2u>(cell);
    return nested_hash2(low, low + 1u, pcg(seed));
}

/// As `cell_hash2`, on a lattice that repeats every `period` cells.
fn cell_hash2_tiled(cell: vec2i, period: vec2u, seed: u32) -> vec4u {
    let low = vec2u(wrap_cell(cell.x, period.x), wrap_cell(cell.y, period.y));
    let high = vec2u(wrap_next(low.x, period.x), wrap_next(low.y, period.y));
    return nested_hash2(low, high, pcg(seed));
}

/// Hashes of the corners of `cell`.
fn cell_hash3(cell: vec3i, seed: u32) -> CellHash3 {
    let low = bitcast<vec3u>(cell);
    return nested_hash3(low, low + 1u, pcg(seed));
}

/// As `cell_hash3`, on a lattice that repeats every `period` cells.
fn cell_hash3_tiled(cell: vec3i, period: vec3u, seed: u32) -> CellHash3 {
    let low = vec3u(wrap_cell(cell.x, period.x), wrap_cell(cell.y, period.y), wrap_cell(cell.z, period.z));
    let high = vec3u(wrap_next(low.x, period.x), wrap_next(low.y, period.y), wrap_next(low.z, period.z));
    return nested_hash3(low, high, pcg(seed));
}

/// Hashes of the four corners with these coordinates. `key`: hash of all that is fixed for them.
fn nested_hash2(low: vec2u, high: vec2u, key: u32) -> vec4u {
    let row0 = pcg(low.y + key);
    let row1 = pcg(high.y + key);
    return vec4u(pcg(low.x + row0), pcg(high.x + row0), pcg(low.x + row1), pcg(high.x + row1));
}

/// Hashes of the eight corners with these coordinates. `key`: the hashed seed.
fn nested_hash3(low: vec3u, high: vec3u, key: u32) -> CellHash3 {
    return CellHash3(
        nested_hash2(low.xy, high.xy, pcg(low.z + key)),
        nested_hash2(low.xy, high.xy, pcg(high.z + key)),
    );
}
