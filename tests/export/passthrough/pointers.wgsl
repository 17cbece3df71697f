var<private> counter: u32 = 3u;
fn add(p: ptr<private, u32>, by: u32) -> u32 { let before = *p; *p = before + by; return before; }
fn swap(a: ptr<function, vec3f>) { (*a).x = (*a).y; a.z = 2.0; }
@compute @workgroup_size(1) fn main() {
    var v = vec3f(1.0);
    swap(&v);
    let q = &v;
    (*q)[1] = 4.0;
    _ = add(&counter, 2u);
}
