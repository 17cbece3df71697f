// Between f32, i32 and u32; to its own type it changes nothing.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4u {
    let f = (floor(at.x) - 32.0) * exp2(floor(at.y) - 32.0);
    let bits = bitcast<u32>(f);
    let next = bitcast<f32>((bits & 0x7FFFFFFFu) + 0x00800000u);
    let i = bitcast<i32>(f);
    return vec4u(bits, bitcast<u32>(next), bitcast<u32>(i >> 3u), bitcast<u32>(bitcast<f32>(f)) + bitcast<u32>(bitcast<i32>(i)));
}
