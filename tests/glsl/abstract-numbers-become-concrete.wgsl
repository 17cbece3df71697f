// Whole numbers where floats are meant, in calls, constructors, operators, returns and declarations.

fn half(x: f32) -> f32 {
    return x / 2;
}

fn one() -> f32 {
    return 1;
}

fn bits(n: u32) -> u32 {
    return n | 1;
}

const GOLD = 1.618;
const SIX = 2 * 3;

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let x = floor(at.x);
    let a: f32 = 3;
    var b: vec2f = vec2(1, 2);
    let c = half(7) + one() + max(x, 1) + clamp(x, 0, 5) + pow(2, 3);
    let d = vec3(1, 2.5, 3);
    let e: u32 = 7;
    let f = array<f32, 2>(1, 2);
    let g = mix(0, 10, x / 64) + smoothstep(0, 1, x);
    let h = select(1, 2.5, x > 4);
    b += 1;
    b = b * SIX;
    var s: f32 = SIX;
    s += -1;
    if x > 3 { s *= 2; }
    return vec4f(a + c + s, b.x + d.y, f32(e + bits(8) + 2) + f[1] + f32(vec2u(1, 2).y), g + h + GOLD * 0 - -1);
}
