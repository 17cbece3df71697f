// Locals called like what a translation to GLSL would call, while the operations that need it follow in the same scope.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let p = floor(at.xy);
    let trunc = p.x - 20.0;
    let floor = p.y + 1.0;
    let mix = vec2<bool>(p.x > 8.0, p.y > 8.0);
    let ivec2 = vec2i(p);
    let uint = 3;
    let int = u32(p.x);
    let clamp = 0.5;
    let lessThan = 2.0;
    let not = true;
    let floatBitsToUint = 1.5;
    let inversesqrt = 4.0;
    let bvec2 = 7u;
    let dFdx = at.x;
    let roundEven = p.x * 0.5;
    let isnan = 3.5;
    let bool = 1.0;
    let a = trunc % floor + saturate(p.x * clamp);
    let b = select(vec2f(1.0, 2.0), p, mix) + vec2f(!mix);
    let c = i32(int) + uint + ivec2.y / ivec2.x + i32(bvec2);
    let d = select(0.0, lessThan, all(p < vec2f(30.0)) && not);
    let e = bitcast<u32>(floatBitsToUint) >> 20u;
    let f = inverseSqrt(inversesqrt) + dpdx(dFdx) + round(roundEven) + bool;
    return vec4f(a + b.x, b.y + f32(c), d + f32(e), f + f32(i32(isnan)) + f32(ivec2.x << 1u));
}
