// Functions of no parameters, of many, of unused ones; a value of every type.

var<private> hits: vec2i;

fn tick() {
    hits.x += 1;
}

fn three() -> i32 {
    tick();
    return 3;
}

fn pick(a: i32, b: u32, c: f32, d: bool, e: vec2f, f: vec3<bool>, g: mat2x2f, unused: vec4f) -> vec3<bool> {
    return vec3<bool>(d, a > i32(b), c > e.x + g[1].y) & f;
}

fn matrix() -> mat2x3f {
    return mat2x3f(1.0, 2.0, 3.0, 4.0, 5.0, 6.0);
}

fn flag(x: i32) -> bool {
    return x % 3 == 0;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let v = pick(x, u32(at.y), at.x, flag(x), at.yx, vec3<bool>(true, x > 9, true), mat2x2f(), at);
    return vec4i(three() + hits.x, dot(vec3i(v), vec3i(1, 2, 4)), i32(matrix()[1].y), i32(flag(x + 1)));
}
