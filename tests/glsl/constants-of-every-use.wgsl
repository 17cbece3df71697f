// One abstract constant used as i32, u32, f32, and in vectors of each.

const N = 3;
const X = N + 0.5;
const M = -N;

fn of_u32(n: u32) -> u32 {
    return n + N;
}

fn of_f32(x: f32) -> f32 {
    return x * N + X;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let i = i32(at.x) * N;
    let u = of_u32(u32(at.y)) << N;
    let f = of_f32(floor(at.x)) / N;
    let v = vec3f(N) + vec3f(X, N, M);
    let w = vec2u(N, 4) + N;
    let z = vec2i(M) * vec2i(i, N);
    var count: u32 = N;
    count += N;
    return vec4f(f32(i) + v.x + v.z, f32(u + w.x + count), floor(f * 64.0), f32(z.x + z.y));
}
