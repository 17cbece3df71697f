// ---- sun ----
const sun_height: f32 = 0.1;
const sun_depth: f32 = 0.1;

// ---- input.wgsl ----
@compute @workgroup_size(1)
fn main() {
    _ = sun_height + sun_depth;
}
