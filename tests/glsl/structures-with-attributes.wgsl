// @size and @align, and a trailing comma, change nothing for values in functions.

struct Padded {
    @align(16) a: f32,
    @size(32) b: vec2i,
    @align(32) @size(16) c: u32,
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let p = Padded(floor(at.x), vec2i(at.yx), 3u,);
    return vec4f(p.a, vec2f(p.b), f32(p.c));
}
