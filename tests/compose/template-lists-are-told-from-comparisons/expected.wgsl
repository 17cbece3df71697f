// ---- a ----
const a_b: i32 = 1;

// ---- input.wgsl ----
const c = 2;
const d = 3;
struct Box { x: i32 }
var<private> list: array<Box, c>;
var<workgroup> shared_list: array<atomic<u32>, (d << 1)>;

fn one(p: ptr<function, array<vec2<f32>, d>>) -> bool {
    let lt = a_b < c;
    let both = a_b < c && d > (a_b);
    let shifted = a_b >> 1u;
    let called = all(vec2<bool>(a_b<c, (d>4)));
    let made = vec3<f32>(f32(a_b)) ;
    return lt && both && a_b<=c && shifted >= 0;
}
