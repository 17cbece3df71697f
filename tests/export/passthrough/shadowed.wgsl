const x = 1.0;
fn f(y: f32) -> f32 { return y; }
@fragment fn main() -> @location(0) vec4f {
    let y = x;
    let x = f(y);
    {
        let f = x + 1.0;
        let x = f;
        var y = array<f32, 2>(x, f);
        return vec4f(y[0], y[1], x, f);
    }
}
