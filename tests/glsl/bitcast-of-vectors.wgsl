// Component by component.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4u {
    let p = floor(at.xy) - 20.0;
    let u = bitcast<vec2u>(p);
    let i = bitcast<vec3i>(vec3f(p, 0.5));
    let f = bitcast<vec4f>(vec4u(u & vec2u(0xFFF00000u), 0x3F800000u, 0x40490FDBu));
    return vec4u(u.x, bitcast<u32>(i.y), bitcast<vec2u>(f.zw).y, bitcast<vec4u>(f + 0.0).x);
}
