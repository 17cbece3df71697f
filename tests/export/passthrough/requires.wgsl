requires pointer_composite_access; // first thing in the file
fn bump(p: ptr<function, i32>) { *p += 1; }
@compute @workgroup_size(1) fn main() { var a = array<i32, 2>(1, 2); bump(&a[1]); }
