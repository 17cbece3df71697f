
// ---- lib.wgsl ----
// About what is used.
fn used() -> f32 { return 1.0; } // behind it

// ---- input.wgsl ----
@fragment fn main() -> @location(0) vec4f {
    return vec4f(used());
}
