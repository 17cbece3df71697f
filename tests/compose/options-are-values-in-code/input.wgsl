#option mode = middle { low, middle, high }
#option steps = 16, range 1 .. 64
#option scene.fog = true
#option plain = false

fn sum(n: i32) -> f32 {
    var sum = 0.0;
    for (var i = 0; i < steps; i++) {
        sum += f32(i * n);
    }
    return select(0.0, sum, scene.fog);
}

@fragment fn main() -> @location(0) vec4f {
    return vec4f(sum(steps));
}
