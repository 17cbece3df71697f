#param a.b: i32 = 1
const c = 2;
const d = 3;
struct Box { x: i32 }
var<private> list: array<Box, c>;
var<workgroup> shared_list: array<atomic<u32>, (d << 1)>;

fn one(p: ptr<function, array<vec2<f32>, d>>) -> bool {
    let lt = a.b < c;
    let both = a.b < c && d > (a.b);
    let shifted = a.b >> 1u;
    let called = all(vec2<bool>(a.b<c, (d>4)));
    let made = vec3<f32>(f32(a.b)) ;
    return lt && both && a.b<=c && shifted >= 0;
}
