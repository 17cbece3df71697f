// `let p = &variable` and pointers to parts, read and written through, while the variable changes under them.

struct Pair { a: i32, b: vec2i }

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    var pair = Pair(i32(at.x), vec2i(at.yx));
    let whole = &pair;
    let part = &(*whole).b;
    let again = part;
    (*part).x += 10;
    pair.b.y += 100;
    (*whole).a -= 1;
    let copy = *whole;
    *again = (*part).yx;
    var n = 5;
    let at_n = &n;
    for (var i = 0; i < 3; i++) { *at_n += i; }
    return vec4i(pair.b, copy.b.x + copy.a * 1000, n + *at_n);
}
