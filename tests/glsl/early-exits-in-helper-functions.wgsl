// Returns of structures, arrays, booleans and vectors out of nested control flow.

struct Hit { found: bool, at: f32 }

fn march(from_: f32, to: f32) -> Hit {
    var t = from_;
    for (var i = 0; i < 32; i++) {
        if t * t > 300.0 { return Hit(true, t); }
        t += 1.5;
        if t > to { break; }
    }
    return Hit();
}

fn first_above(values: array<f32, 4>, limit: f32) -> vec2f {
    for (var i = 0; i < 4; i++) {
        if values[i] > limit { return vec2f(f32(i), values[i]); }
    }
    return vec2f(-1.0);
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let hit = march(floor(at.x) * 0.5, floor(at.y));
    let first = first_above(array<f32, 4>(1.0, floor(at.x), floor(at.y), 40.0), 20.0);
    return vec4f(select(-1.0, 1.0, hit.found), hit.at, first);
}
