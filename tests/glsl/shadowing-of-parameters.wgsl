// A parameter may be hidden in a block, also by a name that a loop or a branch declares.

fn f(p: vec2f, n: i32) -> f32 {
    var r = p.x;
    if n > 3 {
        let p = p * 2.0;
        r += p.x + p.y;
        let n = n - 1;
        r += f32(n);
    } else {
        var n = f32(n);
        n += 0.5;
        r += n;
    }
    for (var p = n; p > 0; p--) { r += f32(p); }
    return r + p.y;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let x = i32(at.x) % 8;
    return vec4f(f(floor(at.xy), x), f(floor(at.yx), 3), f(vec2f(), x), 0.0);
}
