#include "outer.wgsl" as cirrus

@compute @workgroup_size(1)
fn main() {
    _ = cirrus_outer();
}
