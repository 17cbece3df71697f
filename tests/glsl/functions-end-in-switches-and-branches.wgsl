// Functions whose last statement is a switch, a block or an `if` that always returns.

fn by_branch(x: i32) -> i32 {
    var i = x;
    if i % 2 == 0 {
        i += 1;
        if i > 20 { return i; } else { return -i; }
    } else if i > 10 {
        return 10;
    } else {
        return i * 3;
    }
}

fn by_switch_in_block(x: i32) -> i32 {
    {
        switch x & 3 {
            case 0, 1 { return 1; }
            default { { return x; } }
        }
    }
}

fn by_switch(x: i32) -> i32 {
    switch x {
        case 1: { return 10; }
        case 2: { if x > 1 { return 20; } else { return 30; } }
        default: { return x - 1; }
    }
}

fn by_block(x: i32) -> i32 {
    {
        return x + 1;
    }
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    return vec4i(by_branch(x), by_switch_in_block(x), by_switch(x), by_block(i32(at.y)));
}
