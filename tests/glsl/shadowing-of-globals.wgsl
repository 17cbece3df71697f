// Locals and parameters hide constants, private variables and functions; elsewhere these are still there.

const scale = 2.0;
var<private> count: i32 = 1;

fn height(x: f32) -> f32 {
    count += 1;
    return x * scale;
}

fn slope(scale: f32) -> f32 {
    return scale + f32(count);
}

fn both(x: f32) -> f32 {
    let height = height(x) + 1.0;
    let scale = vec2f(height, scale);
    var count = count * 100;
    count += 1;
    return scale.x + scale.y + f32(count);
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let x = floor(at.x);
    let a = both(x);
    let b = slope(x);
    return vec4f(a, b, height(x), f32(count));
}
