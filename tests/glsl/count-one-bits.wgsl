// Of i32 and u32, scalars and vectors.

fn mixed(n: u32) -> u32 {
    let state = n * 747796405u + 2891336453u;
    let word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let n = u32(at.x) + 64u * u32(at.y);
    let u = mixed(n);
    let i = bitcast<i32>(u) >> (n % 32u);
    let v = countOneBits(vec2u(n, ~n));
    return vec4i(i32(countOneBits(u)), countOneBits(i), i32(v.x + v.y * 100u), countOneBits(vec3i(i, 0, -1)).z);
}
