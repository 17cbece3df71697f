// Towards zero, also where the numbers are constants or written in the source.

const MINUS = -7 / 2;
const REST = -7 % 3;

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x) - 32;
    return vec4i(x / 3, x % 3 + 10 * (x % -3), MINUS * 100 + REST, (-x) / 4 * 1000 + 63 / 4 + u_part(u32(at.y)));
}

fn u_part(y: u32) -> i32 {
    return i32(y / 7u * 7u + y % 7u);
}
