// The same without pointers to parts of variables.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let n = i32(at.x);
    let first = (n + 3) + (n + 4);
    let second = (n + 8) + (n + 9);
    return vec4i(first, second, n + 9, n + 9);
}
