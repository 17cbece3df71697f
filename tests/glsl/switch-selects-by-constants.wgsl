// Selectors are constant expressions, and the selector is an expression of its own.

const GRASS = 3;
const ROCK: i32 = GRASS + 1;
const SNOW = ROCK * 2 - 1;

fn albedo(kind: i32) -> i32 {
    switch (kind & 7) + 1 {
        case GRASS { return 30; }
        case ROCK, SNOW { return 70; }
        case SNOW + 1 { return 85; }
        default { return 0; }
    }
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x);
    let y = i32(at.y);
    return vec4i(albedo(x), albedo(y), albedo(x + y), albedo(x * y));
}
