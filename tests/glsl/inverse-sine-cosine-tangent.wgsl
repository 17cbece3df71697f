// tolerance: 5e-4 absolute, since WGSL's asin and acos inherit the error of atan2 (4096 ulp)
// asin, acos, atan, and atan2, which WGSL gives a name of its own.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let x = (floor(at.x) - 31.5) / 32.0;
    let y = (floor(at.y) - 31.5) / 8.0;
    return vec4f(
        asin(x),
        acos(x) + atan(vec2f(x, y)).x,
        atan(y),
        atan2(y, x) + atan2(vec2f(x, 1.0), vec2f(y, 2.0)).x * 0.25,
    );
}
