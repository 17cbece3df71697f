// ---- options ----
const steps: i32 = 16;
// ---- scene ----
const scene_fog: bool = true;

// ---- input.wgsl ----
fn sum(n: i32) -> f32 {
    var sum = 0.0;
    for (var i = 0; i < steps; i++) {
        sum += f32(i * n);
    }
    return select(0.0, sum, scene_fog);
}

@fragment fn main() -> @location(0) vec4f {
    return vec4f(sum(steps));
}
