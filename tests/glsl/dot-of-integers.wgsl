// GLSL has no dot for them; overflow wraps.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x) - 32;
    let y = i32(at.y);
    let u = vec3u(u32(y), 3000000000u, 7u);
    return vec4i(
        dot(vec2i(x, y), vec2i(y, -x + 1)),
        dot(vec3i(x, y, 5), vec3i(2, 3, x)),
        dot(vec4i(x, y, 1, 2147483647), vec4i(y, x, 9, y)),
        bitcast<i32>(dot(u, u.zyx)),
    );
}
