const A = 2;

@fragment fn main() -> @location(0) vec4f {
    return vec4f(f32(A));
}
