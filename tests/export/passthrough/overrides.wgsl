override size: u32 = 8u;
@id(17) override gain: f32 = 0.5;
override flag = true;
override derived: f32 = gain * 2.0;
var<workgroup> tile: array<f32, 64>;
@group(0) @binding(0) var<storage, read_write> out: array<f32>;
@compute @workgroup_size(size, 2)
fn main(@builtin(local_invocation_index) i: u32) {
    tile[i] = select(gain, derived, flag);
    workgroupBarrier();
    out[i] = tile[i ^ 1u];
}
