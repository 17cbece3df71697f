// Whole numbers that a float can hold, from i32 and u32.

const EDGES = array<i32, 8>(0, 1, -1, 16777216, -16777215, 1073741824, -2147483648, 12345678);

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let i = EDGES[i32(at.x) % 8];
    let u = u32(at.y) << (u32(at.x) % 32u);
    return vec4f(f32(i), f32(u & 0xFFFFFF00u), vec2f(vec2i(i, -1)).x, vec3f(vec3u(u & 0xFF000000u, 4294967040u, 3u)).y);
}
