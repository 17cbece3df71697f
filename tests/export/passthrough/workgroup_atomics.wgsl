var<workgroup> total: atomic<u32>;
var<workgroup> unused_tile: array<vec4f, 16>;
@group(1) @binding(2) var<storage, read> input: array<u32>;
@group(1) @binding(3) var<storage, read_write> result: u32;
@compute @workgroup_size(64, 1, 1)
fn sum(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) li: u32) {
    if li == 0u { atomicStore(&total, 0u); }
    workgroupBarrier();
    atomicAdd(&total, input[id.x]);
    workgroupBarrier();
    if (li == 0u) { result = atomicLoad(&total); }
}
