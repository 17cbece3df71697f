
// ---- odd.wgsl ----
const HALF = 3;

// ---- even.wgsl ----
const EVEN = 2 * HALF;

// ---- input.wgsl ----
@fragment fn main() -> @location(0) vec4f {
    return vec4f(f32(EVEN));
}
