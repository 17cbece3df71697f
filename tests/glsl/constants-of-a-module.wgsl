// With and without types, out of each other, in any order, and of vectors and structures.

const SECOND = FIRST * 2.0;
const FIRST = 1.5;
const COUNT: i32 = i32(SECOND) + 4;
const MASK = 0xFFu << 4u;
const UP = vec3f(0, 1, 0);
const SIDE = vec3(1, 0, 0) * 2.0;
const BIG = SECOND > FIRST && COUNT != 3;
const PLACE = Place(UP + SIDE, COUNT);
const TURN = mat2x2f(0, 1, -1, 0);

struct Place { at: vec3f, n: i32 }

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    const LOCAL = PLACE.n * 2;
    var r = vec4f(PLACE.at * floor(at.x), f32(LOCAL)) + vec4f(TURN * floor(at.xy), SIDE.x, 0.0);
    if BIG { r.w += f32(MASK & u32(at.y)); }
    return r + FIRST;
}
