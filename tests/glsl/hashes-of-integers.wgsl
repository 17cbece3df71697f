// A PCG hash and a float from its top bits, as the library makes them.

fn pcg3(v: vec3u) -> vec3u {
    var s = v * 1664525u + 1013904223u;
    s.x += s.y * s.z;
    s.y += s.z * s.x;
    s.z += s.x * s.y;
    s ^= s >> vec3u(16u);
    s.x += s.y * s.z;
    s.y += s.z * s.x;
    s.z += s.x * s.y;
    return s;
}

fn unit(bits: u32) -> f32 {
    return f32(bits >> 8u) * 0x1p-24;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let h = pcg3(vec3u(vec2u(at.xy), 7u));
    return vec4f(unit(h.x), unit(h.y), unit(h.z), unit(h.x ^ bitcast<u32>(-1)));
}
