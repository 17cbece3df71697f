// Built-ins inside built-ins, calls inside constructors inside calls.

fn pair(a: f32, b: f32) -> vec2f {
    return vec2f(a, b);
}

fn sum(v: vec2f) -> f32 {
    return v.x + v.y;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let p = floor(at.xy);
    return vec4f(
        sum(pair(sum(p), sum(pair(p.y, 1.0)))),
        max(min(abs(p.x - 30.0), 9.0), floor(sqrt(p.y * p.y) * 0.5)),
        sum(select(pair(1.0, 2.0), pair(p.x, 3.0), p > pair(8.0, 9.0))),
        dot(vec3f(pair(1.0, p.x), sum(p)), vec3f(vec2f(vec2i(p)).yx, 0.5)),
    );
}
