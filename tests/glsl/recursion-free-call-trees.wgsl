// Functions that call functions that are declared after them, several deep and shared.

fn a(x: i32) -> i32 { return b(x) + c(x); }

fn d(x: i32) -> i32 { return x * 3; }

fn c(x: i32) -> i32 { return d(x) - b(x + 1); }

fn b(x: i32) -> i32 { return d(x) + e(); }

fn e() -> i32 { return 7; }

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    return vec4i(a(i32(at.x)), b(i32(at.y)), c(a(2)), d(e()));
}
