const A = 2;

const B = 3;

@fragment fn main() -> @location(0) vec4f {
    return vec4f(f32(A), f32(B), 0, 1);
}
