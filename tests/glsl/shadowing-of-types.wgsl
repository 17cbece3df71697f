// Locals called like structures, aliases and their own members, while the types stay in use elsewhere.

struct Light { power: f32, Light: f32 }
alias Length = f32;
alias Pair = vec2<Length>;

fn lit(power: f32) -> Light {
    return Light(power, power + 1.0);
}

fn sum(light: Light) -> Length {
    let Light = light.Light;
    let power = light.power * 2.0;
    let Length = Light + power;
    return Length;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let pair = Pair(floor(at.xy));
    let light = lit(pair.x);
    let Pair = 3.0;
    return vec4f(sum(light), light.Light, Pair, pair.y);
}
