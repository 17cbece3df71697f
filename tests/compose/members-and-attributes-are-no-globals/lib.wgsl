const x = 1.0;
const position = 2.0;
const f16_like = 3u;
struct S { x: f32, @align(8) position: f32 }
fn f(s: S) -> f32 {
    var t = s;
    t.x = x;
    (t).position = t.position;
    return t.x + helper(position, 1.0);
}
fn helper(x: f32, y: f32) -> f32 { return x + y; }
