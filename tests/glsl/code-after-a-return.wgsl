// Statements that are never reached, after `return`, `break`, `continue` and `discard`.

fn f(x: i32) -> i32 {
    for (var i = 0; i < 5; i++) {
        if i == x { continue; }
        if i > 3 { break; }
    }
    if x > 10 {
        return 1;
    }
    return 2;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    if x > 60 {
        return vec4i(7);
    } else {
        return vec4i(f(x), f(i32(at.y)), 0, 0);
    }
}
