#param sun.height: f32 = 0.5

@compute @workgroup_size(1)
fn main() {
    _ = sun.height;
}
