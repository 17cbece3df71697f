// Variables, functions, parameters and structures whose names are keywords or reserved in GLSL, free in WGSL.

struct double { input: f32, output: vec2f }

const half = 0.5;
const long = 3;
var<private> volume: f32 = 1.0;

fn sample(float: f32, flat: f32) -> double {
    let in = float * half;
    let out = vec2f(in, flat);
    return double(in + flat, out);
}

fn centroid(invariant: vec2f) -> f32 {
    var inout = invariant.x;
    let float = invariant.y;
    inout += float;
    return inout;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let vec2 = floor(at.xy);
    let texture = sample(vec2.x, 3.0);
    let bvec3 = centroid(vec2);
    let uint = u32(at.y);
    let void = i32(uint) + long;
    let sampler2D = texture.output.x;
    let uniform_ = 2.0;
    let inlined = 2.0;
    let superp = 1.0;
    let fixed = 0.25;
    volume += inlined * 0.5 + uniform_ * 0.5;
    let isampler3D = superp + fixed + volume;
    for (var short = 0; short < 3; short++) { volume += f32(short); }
    return vec4f(texture.input + sampler2D, bvec3, f32(void), isampler3D + volume);
}
