#option on = false
#if on
#include "b.wgsl"
#endif
#include "c.wgsl"

@compute @workgroup_size(1)
fn main() {
    _ = b();
}
