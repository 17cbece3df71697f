// `return` out of blocks, loops and branches; a function without a value returns early too.

var<private> log: i32 = 0;

fn note(x: i32) {
    log += 1;
    if x > 30 { return; }
    log += 10;
    for (var i = 0; i < 8; i++) {
        if i == x { return; }
        log += 100;
    }
    { log += 1000; if x == 20 { return; } }
    log += 10000;
    return;
}

fn least_factor(n: i32) -> i32 {
    if n < 4 { return n; }
    var i = 2;
    while i * i <= n {
        if n % i == 0 { return i; }
        i++;
    }
    return n;
}

fn both(x: i32) -> i32 {
    if x > 20 { return 1; } else { return 2; }
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    note(x);
    if x == 63 { return vec4i(-1, log, 0, 0); }
    return vec4i(least_factor(x * 3 + i32(at.y)), log, both(x), 1);
}
