// dpdx, dpdy, fwidth and their coarse and fine kin, of functions that are linear in x and the row's distance.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let f = at.x * 3.0;
    let g = at.xy * vec2f(2.0, 5.0);
    return vec4f(
        dpdx(f) + dpdxCoarse(f) * 10.0 + dpdxFine(f) * 100.0,
        abs(dpdy(g.y)) + abs(dpdyCoarse(g)).y * 10.0 + abs(dpdyFine(g)).y * 100.0,
        fwidth(f) + fwidthCoarse(g).y * 10.0 + fwidthFine(g).x * 100.0,
        dpdx(vec3f(at.x, 1.0, at.x * at.x * 0.0)).x,
    );
}
