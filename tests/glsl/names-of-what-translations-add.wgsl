// Functions and constants called like helpers, and like a translator's own temporaries.

fn count_one_bits(x: u32) -> u32 {
    return x + 1u;
}

fn divide(a: i32, b: i32) -> i32 {
    return a - b;
}

fn remainder(a: i32, b: i32) -> i32 {
    return a + b;
}

fn countOneBits_(x: u32) -> u32 {
    return x * 2u;
}

fn ldexp_(x: f32) -> f32 {
    return x;
}

const index = 3;
const temp = 4;
const result = 5;
const fragColor = 6;
const _e1 = 7;
const loop_init = true;

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let y = i32(at.y);
    var list = array<i32, 4>(1, 2, 3, 4);
    var t = 0;
    loop {
        t += 1;
        if t % 2 == 0 { continue; }
        continuing { list[x & 3] += index; break if t > y && loop_init; }
    }
    let a = x / (y - 3) + divide(x, y) * 100;
    let b = x % (y - 3) + remainder(x, y) * 100;
    let c = countOneBits(u32(x)) + count_one_bits(u32(y)) * 100u + countOneBits_(7u) * 10000u;
    return vec4i(a, b, i32(c) + i32(ldexp(ldexp_(1.0), 2)), list[x & 3] + temp + result + fragColor + _e1);
}
