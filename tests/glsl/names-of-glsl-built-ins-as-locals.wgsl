// Locals called like functions that only GLSL has, or that both have; the function of that name is still called before.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let p = floor(at.xy);
    let before = mix(p.x, p.y, 0.5) + clamp(p.x, 3.0, 9.0) + fract(p.x * 0.25) + atan2(1.0, 1.0) * 0.0;
    let mix = before * 2.0;
    let distance = p.x + 1.0;
    let fract = distance * 0.5;
    let clamp = vec2f(mix, fract);
    let lessThan = clamp.x < 20.0;
    let texelFetch = select(1.0, 2.0, lessThan);
    let dFdx = inverseSqrt(4.0) + 1.0;
    let inversesqrt = dFdx * 2.0;
    let not = f32(p.x % 3.0);
    let equal = vec2f(not, length(vec2f(3.0, 4.0)));
    let length = equal.y;
    let floatBitsToInt = bitcast<i32>(1.0) / 4096;
    let atan = 0.125;
    return vec4f(clamp + texelFetch, inversesqrt + equal.x + length, f32(floatBitsToInt) + atan);
}
