struct OrogenParams {
    one_a: f32,
    one_b: u32,
    _pad0: vec2u,
    two_a: vec2f,
    _pad1: vec2u,
    three_a: vec3f,
    _pad2: u32,
    four_a: f32,
}
@group(0) @binding(0) var<uniform> orogen: OrogenParams;

// ---- input.wgsl ----
fn f() -> f32 {
    return orogen.one_a + f32(orogen.one_b) + orogen.two_a.x + orogen.three_a.x + orogen.four_a;
}
