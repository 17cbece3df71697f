const A = array(
    1, // (plain && plain) || fog
    2, // fog || (plain && plain)
    3, // (steps > 8) == fog
    4,
    5,
    6
);

@fragment fn main() -> @location(0) vec4f {
    return vec4f(f32(A[0]));
}
