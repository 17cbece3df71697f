// Each case declares the same names anew, with other types, and hides those outside.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let value = x * 3;
    var r = vec4i();
    switch x % 4 {
        case 0: { let value = vec2i(x, 7); r.x = value.y; }
        case 1: { var value = u32(x) + 1u; value *= 2u; r.x = i32(value); }
        case 2: { let value = value + 1; r.x = value; }
        default: { r.x = value; }
    }
    r.y = value;
    return r;
}
