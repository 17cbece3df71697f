// Names declared in a block end with it.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    var a = i32(at.x);
    let b = i32(at.y);
    {
        let b = a + 1;
        a += b;
        {
            var a = b * 2;
            a += 1;
            let b = a;
            _ = b;
        }
    }
    {}
    { { a -= b; } }
    if a > 0 { let a = 3; _ = a; }
    return vec4i(a, b, 0, 0);
}
