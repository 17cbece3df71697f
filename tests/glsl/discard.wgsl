// Pixels that are given up keep what the target was cleared to, zero.

fn drop_some(p: vec2i) {
    if (p.x + p.y) % 5 == 0 { discard; }
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let p = vec2i(at.xy);
    drop_some(p);
    if p.x == 7 {
        discard;
    }
    return vec4i(p, 1, 2);
}
