// tolerance: 1e-6 relative, since WGSL's sqrt inherits the error of a division by inverseSqrt
// sqrt and inverseSqrt, of scalars and vectors.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let x = floor(at.x) + 1.0;
    let y = floor(at.y) * 1000.0 + 0.001;
    return vec4f(sqrt(x), inverseSqrt(x), sqrt(vec2f(y, x)).x, inverseSqrt(vec3f(1.0, x, y)).z);
}
