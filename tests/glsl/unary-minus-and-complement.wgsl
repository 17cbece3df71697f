// The least number is its own negative; `~` turns every bit.

const EDGES = array<i32, 8>(0, 1, -1, 5, -5, 2147483647, -2147483647, -2147483648);

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let a = EDGES[i32(at.x) % 8];
    let v = -vec2i(a, 3);
    let u = ~vec3u(u32(at.y), 0u, 5u);
    return vec4i(-a, ~a, v.x - - a + -(-3), bitcast<i32>(u.x) + bitcast<i32>(~u.z));
}
