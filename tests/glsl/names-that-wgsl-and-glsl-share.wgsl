// A function of the author's that hides a built-in of WGSL, while other files' text still means it.

fn smoothstep(low: f32, high: f32, x: f32) -> f32 {
    return select(0.0, 1.0, x > low && x < high);
}

fn dot(a: vec2f, b: vec2f) -> f32 {
    return a.x * b.y;
}

fn abs(x: f32) -> f32 {
    return max(x, -x) + 1.0;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let p = floor(at.xy);
    return vec4f(smoothstep(3.0, 20.0, p.x), dot(p, p + 1.0), abs(p.y - 30.0), length(vec2f(3.0, 4.0)) + distance(p, p));
}
