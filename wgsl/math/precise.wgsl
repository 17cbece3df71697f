// Places known to a millionth of a unit however far from the origin: a whole cell and a fraction of it.
//
// An f32 near 6,371,000 moves in steps of one half. Integers do not: what is whole is kept as i32, and only the rest as f32.

/// A place: `cell` + `fraction`. The fraction is 0 .. 1 in each coordinate.
struct Precise {
    /// The whole part.
    cell: vec3i,
    /// The rest.
    fraction: vec3f,
}

/// The place `p`, each coordinate between -2e9 and 2e9; as exact as `p` is.
fn precise_place(p: vec3f) -> Precise {
    let whole = floor(p);
    return Precise(vec3i(whole), p - whole);
}

/// `place` moved by `offset`: as exact as `offset` is, whatever the place.
fn precise_moved(place: Precise, offset: vec3f) -> Precise {
    let carry = floor(offset);
    let rest = place.fraction + (offset - carry); // 0 .. 2
    let over = floor(rest);
    return Precise(place.cell + vec3i(carry) + vec3i(over), rest - over);
}

/// `place` in cells 2^`level` times as large, `level` 0 .. 30: no rounding but that of the new fraction.
fn precise_coarser(place: Precise, level: u32) -> Precise {
    let whole = place.cell >> vec3u(level); // toward minus infinity, also below zero
    let rest = place.cell - (whole << vec3u(level));
    let fraction = (vec3f(rest) + place.fraction) * exp2(-f32(level));
    return Precise(whole, min(fraction, vec3f(0.99999994)));
}

/// `place` in cells 2^`level` times as small; the cell must still fit an i32.
fn precise_finer(place: Precise, level: u32) -> Precise {
    let fraction = place.fraction * exp2(f32(level));
    let whole = floor(fraction);
    return Precise((place.cell << vec3u(level)) + vec3i(whole), fraction - whole);
}
