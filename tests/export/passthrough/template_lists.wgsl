alias Table = array<vec2<f32>, 4>;
alias Nested=array<array<vec2<f32>,2>,(3 >> 1)>;
var<private> t: Table;
fn less(a: i32, b: i32, c: i32) -> bool { return a<b && (b>c) == (a < (b >> u32(c))); }
@fragment fn main() -> @location(0) vec4<f32> {
    let n = Nested(array<vec2<f32>, 2>(vec2<f32>(1.), vec2<f32>(.5e1f)));
    let h = 0x1.8p1f + bitcast<f32>(0x3f800000u);
    return vec4<f32>(t[1] + n[0][1], h, f32(less(1, 2, 3)));
}
