// Precedence and associativity of arithmetic and comparison; minus signs in a row.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x) - 30;
    let y = i32(at.y) + 1;
    let a = x - y - 3 * x / y * 2 % 5;
    let b = -x * -y - -3;
    let c = (x + y) * (x - y) / (y + 1);
    let d = (x < y) == (y > 3);
    let e = (!(x < y) && !(x == 3)) || x - 1 > y * 2;
    let f = -(-(x)) + - 1 - -(-y);
    return vec4i(a, b, c * 4 + i32(d) + 2 * i32(e), f);
}
