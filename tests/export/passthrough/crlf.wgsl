// Windows line ends
fn helper(x: f32) -> f32 {
    return x * 2.0; /* a
 block */
}



@fragment fn main() -> @location(0) vec4f {
	return vec4f(helper(0.5));
}
