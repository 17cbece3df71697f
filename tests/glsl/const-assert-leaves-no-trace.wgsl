// Static assertions stand at module scope and in functions, with and without parentheses.

const STEPS = 12;
const_assert STEPS > 4;
const_assert(STEPS % 3 == 0 && true);

fn halved(x: i32) -> i32 {
    const half = STEPS / 2;
    const_assert half == 6;
    return x / half;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    const_assert(sqrt(4.0) < 2.5);
    return vec4i(halved(i32(at.x)), STEPS, 0, 0);
}
