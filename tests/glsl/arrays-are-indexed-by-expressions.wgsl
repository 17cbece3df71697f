// Indices of either signedness, computed, nested, and out of calls.

var<private> table: array<i32, 8> = array<i32, 8>(3, 1, 4, 1, 5, 7, 2, 6);

fn wrap(i: i32) -> u32 {
    return u32(i) & 7u;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let y = u32(at.y);
    table[wrap(x)] = 0;
    return vec4i(
        table[table[table[y % 8u]]],
        table[wrap(x * 3 + 1)] * 10 + table[(x / 2 + 1) & 7],
        table[7u - y / 8u],
        array<i32, 4>(10, 20, 30, 40)[x & 3] + vec4i(1, 2, 3, 4)[y & 3u],
    );
}
