// `let x = x + 1.0;` in an inner scope reads the outer x, in every kind of declaration and block.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let x = floor(at.x);
    var y = floor(at.y);
    var r = vec4f();
    {
        let x = x + 1.0;
        r.x += x;
        {
            var x = x * 2.0;
            x += 0.5;
            r.x += x;
            { const x = 3.0; r.x += x; }
        }
        var y: f32 = y + x;
        y *= 2.0;
        r.y += y;
    }
    if x > 5.0 {
        let x = i32(x) * 3;
        let y = vec2f(y, f32(x));
        r.z += y.x + y.y;
    }
    while y > 3.0 {
        let step = y * 0.5 + 1.0;
        y -= step;
        let y = step;
        r.w += y;
    }
    for (var x = x; x < 70.0; x += 8.0) { let x = -x; r.w += x; }
    return r + x + y;
}
