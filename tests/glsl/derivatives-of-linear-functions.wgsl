// dpdx, dpdy, fwidth and their coarse and fine kin, of functions that are linear in x and in the row's distance.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let slope = floor(at.x / 2.0) + 1.0; // the same in each square of four pixels
    let f = at.x * slope;
    let g = at.xy * vec2f(slope, 5.0);
    return vec4f(
        dpdx(f) + dpdxCoarse(f) * 100.0 + dpdxFine(f) * 10000.0,
        dpdy(g.y) + dpdyCoarse(g).y * 10.0 + dpdyFine(g).y * 100.0 + slope,
        fwidth(f) + fwidthCoarse(g).y * 100.0 + fwidthFine(g).x * 10000.0,
        dpdx(vec3f(at.x, 1.0, at.x * 0.0)).x,
    );
}
