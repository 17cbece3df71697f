// By value: what is done to the copy leaves the original alone.

fn doubled(values: array<f32, 3>) -> array<f32, 3> {
    var result = values;
    for (var i = 0; i < 3; i++) { result[i] *= 2.0; }
    return result;
}

fn pick(values: array<f32, 3>, i: i32) -> f32 {
    return values[i];
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let values = array<f32, 3>(floor(at.x), floor(at.y), 3.0);
    let i = i32(at.x) % 3;
    return vec4f(doubled(values)[1], doubled(doubled(values))[i], pick(values, i), pick(array<f32, 3>(), i) + values[0]);
}
