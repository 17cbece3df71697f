// WGSL lets a pointer stand before `.` and `[` without a `*`.

struct Box { low: vec2i, high: vec2i }

fn grow(box: ptr<function, Box>, at: vec2i) {
    box.low = min(box.low, at);
    box.high = max(box.high, at);
    box.high.x += 1;
}

fn third(list: ptr<function, array<i32, 4>>) -> i32 {
    list[2] += 1;
    return list[2];
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    var box = Box(vec2i(20), vec2i(30));
    grow(&box, vec2i(at.xy));
    grow(&box, vec2i(at.yx) - 5);
    var list = array<i32, 4>(1, 2, i32(at.x), 4);
    return vec4i(box.low, box.high) + vec4i(third(&list)) * 100;
}
