// Doubled, around callees' arguments, conditions, left sides, selectors, loops and returns.

fn f(a: f32, b: f32) -> f32 {
    return (((a) - ((b))));
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    var v = (vec4f((floor(at.xy)), (1.0), ((2.0))));
    (v.x) += (3.0);
    ((v)).y -= f((v.x), ((4.0)));
    (v[(2)]) = (v.w);
    var i = (0);
    (i)++;
    while ((i) < (3)) { (i) = (i + (1)); }
    switch ((i)) { case (3): { v.w = (9.0); } default: {} }
    if ((v.x > 5.0)) { return (v); }
    return ((v.yxzw));
}
