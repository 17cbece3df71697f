// Assigning a structure, an array or a matrix copies it; a self-assignment of parts takes the old ones.

struct Node { v: vec3f, list: array<i32, 2> }

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let p = floor(at.xy);
    var a = Node(vec3f(p, 1.0), array<i32, 2>(1, 2));
    var b = a;
    b.v = b.v.zxy;
    b.list = array<i32, 2>(b.list[1], b.list[0] + 5);
    a = b;
    b.v.x = 100.0;
    var m = mat2x2f(p, p.yx);
    m = mat2x2f(m[1], m[0]);
    var v = vec2f(p);
    v = vec2f(v.y, v.x);
    v.x = v.y;
    return vec4f(a.v.x + b.v.x, f32(a.list[0] * 10 + a.list[1]), m[0].x, v.x + v.y * 64.0);
}
