// `return` from a switch in a loop leaves the function.

fn find(limit: i32, wanted: i32) -> i32 {
    for (var i = 0; i < limit; i++) {
        switch i * i {
            case 16: { if wanted == 16 { return i; } }
            case 25, 36: { if wanted > 20 { return 100 + i; } break; }
            default: {}
        }
    }
    return -1;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let y = i32(at.y);
    return vec4i(find(x, y), find(y, x), find(x, 16), find(10, y));
}
