
// ---- shared.wgsl ----
fn shared_value() -> f32 { return 0.25; }

// ---- a.wgsl ----
fn a() -> f32 { return shared_value(); }

// ---- b.wgsl ----
fn b() -> f32 { return 2.0 * shared_value(); }

// ---- input.wgsl ----
@fragment fn main() -> @location(0) vec4f {
    return vec4f(a() + b() + shared_value());
}
