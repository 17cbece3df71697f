// What nothing uses may go or stay, and must not break the rest.

struct Unused { a: f32 }
const NEVER = 3.0;
var<private> idle: vec4f;
override spare: f32 = 1.0;

fn forgotten(u: Unused) -> f32 {
    return u.a + NEVER + idle.x + spare;
}

fn partly(a: f32, b: f32) -> f32 {
    let c = b * 2.0;
    var d = c;
    return a;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let unread = floor(at.y);
    return vec4f(partly(floor(at.x), 2.0));
}
