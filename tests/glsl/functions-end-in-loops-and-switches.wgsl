// Functions whose last statement is a loop or a switch that always returns, or an `if` whose branches all do.

fn by_loop(x: i32) -> i32 {
    var i = x;
    loop {
        i += 7;
        if i % 10 == 3 { return i; }
    }
}

fn by_for(x: i32) -> i32 {
    for (var i = x; ; i++) {
        if (i & 15) == 5 { return i; }
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
    return vec4i(by_loop(x), by_for(x), by_switch(x), by_block(i32(at.y)));
}
