// The bits stay.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4u {
    let x = i32(at.x) - 32;
    let u = u32(x);
    let back = i32(u * 3u);
    return vec4u(u, u32(back / 2), vec2u(vec2i(x, -7)).y, u32(vec3i(vec3u(u)).z - 1) + u32(true));
}
