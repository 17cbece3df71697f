// Members, components and elements of what a call returns, indexed and called on at once.

struct Hit { normal: vec3f, t: array<f32, 2>, frame: mat2x2f }

fn trace(x: f32) -> Hit {
    return Hit(vec3f(x, 1.0, 2.0), array<f32, 2>(x, 5.0), mat2x2f(x, 1.0, 2.0, 3.0));
}

fn list(x: f32) -> array<Hit, 2> {
    return array<Hit, 2>(trace(x), trace(x + 1.0));
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let x = floor(at.x);
    let i = i32(at.y) & 1;
    return vec4f(
        trace(x).normal.zx.y + trace(x).t[i],
        trace(x).frame[i].y + trace(2.0).frame[1][i],
        list(x)[i].normal.x + list(x)[1].t[i],
        (trace(x).frame * vec2f(1.0, 2.0)).x + (trace(x).normal + 1.0)[i],
    );
}
