const A = array(
    1,
    2,
    3,
    4,
    5
);

@fragment fn main() -> @location(0) vec4f {
    return vec4f(f32(A[0]));
}
