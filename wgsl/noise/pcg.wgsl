// Integer hashes of the PCG family (Jarzynski & Olano 2020, "Hash Functions for GPU Rendering", JCGT 9(3)).
//
// Bit-exact on every GPU. The low bits are the weak ones: take floats from the top 24 bits, as the helpers below do.

/// Hash of one integer (PCG RXS-M-XS).
fn pcg(value: u32) -> u32 {
    let state = value * 747796405u + 2891336453u;
    let word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

/// Two hashes of two integers. Single input bits turn single output bits over by up to .04 off one half.
fn pcg2d(value: vec2u) -> vec2u {
    var v = value * 1664525u + 1013904223u;
    v.x += v.y * 1664525u;
    v.y += v.x * 1664525u;
    v ^= v >> vec2u(16u);
    v.x += v.y * 1664525u;
    v.y += v.x * 1664525u;
    v ^= v >> vec2u(16u);
    return v;
}

/// Three hashes of three integers, without the final xorshift of the paper's version (it only stirs the low bits).
fn pcg3d(value: vec3u) -> vec3u {
    var v = value * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> vec3u(16u);
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return v;
}

/// Hash of a cell of a plane. Nested one-dimensional hashes: cells of one row share the inner two.
fn pcg_cell2(cell: vec2i, seed: u32) -> u32 {
    return pcg(bitcast<u32>(cell.x) + pcg(bitcast<u32>(cell.y) + pcg(seed)));
}

/// The top 24 bits as a number, 0 <= result < 1, every value exact.
fn unit_float(bits: u32) -> f32 {
    return f32(bits >> 8u) * (1.0 / 16777216.0);
}

/// `unit_float` of two hashes.
fn unit_float2(bits: vec2u) -> vec2f {
    return vec2f(bits >> vec2u(8u)) * (1.0 / 16777216.0);
}

/// `unit_float` of three hashes.
fn unit_float3(bits: vec3u) -> vec3f {
    return vec3f(bits >> vec3u(8u)) * (1.0 / 16777216.0);
}

/// The top 24 bits as a number, -1 <= result < 1, every value exact.
fn signed_float(bits: u32) -> f32 {
    return f32(bits >> 8u) * (1.0 / 8388608.0) - 1.0;
}

/// `signed_float` of four hashes.
fn signed_float4(bits: vec4u) -> vec4f {
    return vec4f(bits >> vec4u(8u)) * (1.0 / 8388608.0) - 1.0;
}
