// The least integer is its own absolute value; a u32 is left as it is.

const EDGES = array<i32, 8>(0, 1, -1, 77, -77, 2147483647, -2147483647, -2147483648);

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let i = EDGES[i32(at.x) % 8];
    let j = EDGES[i32(at.y) % 8];
    let f = abs(floor(at.x) - 31.5);
    let v = abs(vec2f(-f, f - 20.0));
    let u = abs(bitcast<u32>(i));
    return vec4i(abs(i), abs(vec2i(i, j)).y, bitcast<i32>(u), i32(v.x * 2.0 + v.y * 200.0 + abs(-3.0)));
}
