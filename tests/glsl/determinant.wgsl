// Of 2x2, 3x3 and 4x4, of small whole numbers.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let p = floor(at.xy) - 20.0;
    let two = mat2x2f(p.x, 2.0, 3.0, p.y);
    let three = mat3x3f(p.x, 1.0, 0.0, 2.0, p.y, 1.0, 0.0, 3.0, 2.0);
    let four = mat4x4f(1.0, 0.0, 2.0, 0.0, 0.0, p.x, 0.0, 1.0, 3.0, 0.0, 1.0, 0.0, 0.0, 2.0, 0.0, p.y);
    return vec4f(determinant(two), determinant(three), determinant(four), determinant(transpose(two)));
}
