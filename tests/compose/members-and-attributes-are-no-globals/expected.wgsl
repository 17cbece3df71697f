
// ---- lib.wgsl as my ----
const my_x = 1.0;
const my_position = 2.0;
struct my_S { x: f32, @align(8) position: f32 }
fn my_f(s: my_S) -> f32 {
    var t = s;
    t.x = my_x;
    (t).position = t.position;
    return t.x + my_helper(my_position, 1.0);
}
fn my_helper(x: f32, y: f32) -> f32 { return x + y; }

// ---- input.wgsl ----
@fragment fn main() -> @location(0) vec4f {
    return vec4f(my_f(my_S(1.0, 2.0)));
}
