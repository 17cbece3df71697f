#include "quiet.wgsl"
#include "limits.wgsl"

@compute @workgroup_size(1)
fn main() {
    _ = 1.0;
}
