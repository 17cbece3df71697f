// Each of the three parts of a `for` may be missing.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    var r = vec4i();
    var i = 0;
    for (; i < x; i++) { r.x += i; }
    for (var j = 0; ; j++) {
        if j >= x { break; }
        r.y += j;
    }
    for (var k = 0; k < x; ) {
        r.z += k;
        k += 2;
    }
    var n = x;
    for (;;) {
        if n < 0 { break; }
        n -= 3;
        r.w += 1;
    }
    return r;
}
