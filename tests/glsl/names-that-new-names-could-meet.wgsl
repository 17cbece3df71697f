// A reserved name beside the names that a translator would think of in its place.

const sample = 1.0;
const sample_ = 10.0;
const sample_1 = 100.0;
const sample1 = 1000.0;
const _sample = 10000.0;
const sample_value = 100000.0;

struct input { output: f32, output_: f32, output_1: f32, output1: f32 }

fn texture(a: f32) -> f32 {
    return a + 0.5;
}

fn texture_(a: f32) -> f32 {
    return a + 0.25;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let input_ = floor(at.x);
    let input1 = input_ + 1.0;
    let half = input(input_, input1, 3.0, 4.0);
    let half_ = texture(half.output) + texture_(half.output_);
    let half_1 = half.output_1 + half.output1;
    return vec4f(sample + sample_ + sample_1, sample1 + _sample + sample_value, half_, half_1);
}
