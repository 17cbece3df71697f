// `default` may stand among the selectors of a case, and anywhere in the switch.

fn first(x: i32) -> i32 {
    switch x {
        default { return 90; }
        case 1 { return 91; }
        case 2 { return 92; }
    }
}

fn among(x: i32) -> i32 {
    var r = 0;
    switch x {
        case 1: { r = 1; }
        case 5, default, 6: { r = 2; }
        case 9: { r = 3; }
    }
    return r;
}

fn only(x: i32) -> i32 {
    var r = x;
    switch x {
        default: { r += 3; }
    }
    return r;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    return vec4i(first(x), among(x), only(x), first(i32(at.y)));
}
