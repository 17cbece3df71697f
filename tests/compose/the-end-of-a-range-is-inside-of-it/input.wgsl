#param sun.height: f32 = 0.1, range 0 .. 0.1
#param sun.depth: f32 = 0.0, range 0 .. 0.1

@compute @workgroup_size(1)
fn main() {
    _ = sun.height + sun.depth;
}
