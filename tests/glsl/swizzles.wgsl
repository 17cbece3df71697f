// Reading components in any order, repeated, in the colour letters too, and of expressions in parentheses.

fn made(p: vec2f) -> vec4f {
    return vec4f(p, 3.0, 4.0);
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let p = floor(at.xy);
    let a = p.xxyy;
    let b = (p + 1.0).yx;
    let c = made(p).zw.yxyx.zzw;
    let d = vec4f(p, p).rgba.bgr;
    let e = (p * 2.0).xyx[1];
    let f = vec3i(1, 2, 3).zyx.x;
    let g = (vec2<bool>(true, p.x > 5.0)).yx;
    return vec4f(a.x + b.x + c.x, b.y + c.y + d.y, a.w + d.z + c.z, e + f32(f) + f32(g.x));
}
