// Several selectors share a body; `default` stands last.

fn kind(x: i32) -> i32 {
    switch x {
        case 0, 2, 4, 6 { return 10; }
        case 1, 3, 5, 7, {
            return 11;
        }
        case -1: { return 12; }
        default: { return x; }
    }
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let x = i32(at.x) - 4;
    var word = 0;
    switch (i32(at.y) % 5) {
        case 0: {}
        case 1, 2: { word = 5; }
        default: { word = 7; }
    }
    return vec4i(kind(x), kind(-x), word, kind(word));
}
