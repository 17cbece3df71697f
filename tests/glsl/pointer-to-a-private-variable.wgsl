// Private globals through pointers, and at the same time by name elsewhere.

var<private> seed: u32 = 17u;
var<private> grid: array<vec2i, 3>;

fn draw(state: ptr<private, u32>) -> u32 {
    *state = *state * 1664525u + 1013904223u;
    return *state >> 8u;
}

fn put(cells: ptr<private, array<vec2i, 3>>, i: i32) {
    (*cells)[i] = vec2i(i, 7);
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    seed += u32(at.x);
    let a = draw(&seed);
    let b = draw(&seed);
    put(&grid, i32(at.y) % 3);
    return vec4i(i32(a), i32(b), grid[1].y, grid[2].x + i32(seed & 0xFFu));
}
