// The file says what it is.

#include <lib.wgsl>

// Nobody asks for it.
const UNUSED = 1;

@compute @workgroup_size(SIZE)
fn work() {
    _ = used();
}

fn unused() -> f32 { return 1.0; }

@fragment
fn paint() -> @location(0) vec4f { return vec4f(used()); }
