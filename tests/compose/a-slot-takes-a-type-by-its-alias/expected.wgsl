
// ---- apply.wgsl ----
fn applied() -> f32 { return noise(vec2f(1.0)); }

// ---- input.wgsl ----
alias Place = vec2<f32>;
fn noise(p: Place) -> f32 { return p.x; }

@fragment fn main() -> @location(0) vec4f {
    return vec4f(applied());
}
