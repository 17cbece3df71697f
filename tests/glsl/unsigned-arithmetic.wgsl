// Wrapping sums and differences, division, remainder, comparison above 2^31, conversion.

const EDGES = array<u32, 8>(0u, 1u, 2u, 7u, 65536u, 2147483648u, 4294967294u, 4294967295u);

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4u {
    let a = EDGES[u32(at.x) % 8u];
    let b = EDGES[u32(at.y) % 8u];
    let less = u32(a < b) + 2u * u32(a >= b + 1u);
    return vec4u(a + b, a - b, a * b + less, (a / b) ^ (a % b) ^ (min(a, b) << 1u) ^ max(a, 3u));
}
