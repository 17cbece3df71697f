// ---- sun ----
const sun_height: f32 = 0.5;

// ---- input.wgsl ----
@compute @workgroup_size(1)
fn main() {
    _ = sun_height;
}
