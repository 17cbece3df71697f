// Through three functions, and to parts of what a pointer points to.

struct Deep { list: array<vec2i, 2>, n: i32 }

fn add(n: ptr<function, i32>, by: i32) -> i32 {
    *n += by;
    return *n;
}

fn middle(d: ptr<function, Deep>, by: i32) -> i32 {
    let first = add(&(*d).n, by);
    return first + add(&(*d).n, 1);
}

fn outer(d: ptr<function, Deep>) -> i32 {
    (*d).list[1] = vec2i(middle(d, 3), middle(d, 4));
    return (*d).n;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    var d = Deep(array<vec2i, 2>(), i32(at.x));
    let end = outer(&d);
    return vec4i(d.list[1], end, d.n);
}
