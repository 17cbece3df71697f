const A = array(
    1,
    2,
    3,
    4,
    5,
    6,
    7,
    8,
    9
);

@fragment fn main() -> @location(0) vec4f {
    return vec4f(f32(A[0]));
}
