// One shape in every cell of a grid, in a row of so many, or around an axis; and which cell it is.
//
// A distance taken in one cell knows nothing of its neighbours': it is a bound only while every copy stays in its own cell
// and is symmetric in it, else take the least over the neighbouring cells. The cell's number gives every copy a hash of
// its own (`pcg_cell2`, `pcg3d`).

/// A place in one cell of a plane.
struct Repeated2 {
    /// Where it is as seen from the middle of the cell.
    local: vec2f,
    /// Which cell.
    cell: vec2i,
}

/// A place in one cell of space.
struct Repeated3 {
    /// Where it is as seen from the middle of the cell.
    local: vec3f,
    /// Which cell.
    cell: vec3i,
}

/// A place in one sector around an axis.
struct RepeatedSector {
    /// Where it is, turned so that the middle of the sector lies along +x.
    local: vec2f,
    /// Which sector, 0 .. count - 1; the first has its middle along +x.
    sector: i32,
}

/// The cell of size `spacing` > 0 that `p` lies in; cell (0, 0) has its middle at the origin. `local` is within
/// +-`spacing / 2`. |p / spacing| must be below 2³¹.
fn repeat2(p: vec2f, spacing: vec2f) -> Repeated2 {
    let cell = floor(p / spacing + 0.5);
    return Repeated2(p - spacing * cell, vec2i(cell));
}

/// As `repeat2`, in space.
fn repeat3(p: vec3f, spacing: vec3f) -> Repeated3 {
    let cell = floor(p / spacing + 0.5);
    return Repeated3(p - spacing * cell, vec3i(cell));
}

/// As `repeat2`, for the cells `first` .. `last` only: beyond them `local` goes on growing.
fn repeat2_within(p: vec2f, spacing: vec2f, first: vec2i, last: vec2i) -> Repeated2 {
    let cell = clamp(floor(p / spacing + 0.5), vec2f(first), vec2f(last));
    return Repeated2(p - spacing * cell, vec2i(cell));
}

/// As `repeat3`, for the cells `first` .. `last` only: beyond them `local` goes on growing.
fn repeat3_within(p: vec3f, spacing: vec3f, first: vec3i, last: vec3i) -> Repeated3 {
    let cell = clamp(floor(p / spacing + 0.5), vec3f(first), vec3f(last));
    return Repeated3(p - spacing * cell, vec3i(cell));
}

/// The one of `count` >= 1 equal sectors around the origin that `p` lies in. Keeps the distance to the origin.
fn repeat_sectors(p: vec2f, count: i32) -> RepeatedSector {
    let width = 6.2831853 / f32(count);
    let at = atan2(p.y, select(p.x, 1e-30, p.x == 0.0 && p.y == 0.0));
    let sector = floor(at / width + 0.5);
    let turn = -sector * width;
    let c = cos(turn);
    let s = sin(turn);
    let local = vec2f(c * p.x - s * p.y, s * p.x + c * p.y);
    return RepeatedSector(local, (i32(sector) + count) % count);
}
