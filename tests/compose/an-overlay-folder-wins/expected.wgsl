
// ---- tests/compose/an-overlay-folder-wins/overlay/value.wgsl ----
fn value() -> f32 { return 1.0; } // laid over

// ---- input.wgsl ----
@fragment fn main() -> @location(0) vec4f {
    return vec4f(value());
}
