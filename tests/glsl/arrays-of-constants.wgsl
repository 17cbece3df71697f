// Tables at module scope and in functions, with and without their type, indexed by constants and variables.

const PRIMES = array(2, 3, 5, 7, 11, 13, 17, 19);
const WEIGHTS: array<f32, 4> = array(0.25, 1, 2, 0.5);
const CORNERS = array<vec2f, 3>(vec2f(-1, -1), vec2f(3, -1), vec2f(-1, 3));
const COUNT = 4u;

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    const local = array<u32, COUNT>(9u, 8u, 7u, 6u);
    let i = i32(at.x) % 8;
    let j = u32(at.y) % COUNT;
    var sum = 0.0;
    for (var k = 0u; k < COUNT; k++) { sum += WEIGHTS[k] * f32(local[k]); }
    return vec4f(f32(PRIMES[i] + PRIMES[1]), WEIGHTS[j] + sum, CORNERS[i % 3].x + CORNERS[2].y, f32(local[j] + local[0]));
}
