// Functions called for what they do; a value that may be dropped is dropped.

var<private> total: vec2i;

fn add(v: vec2i) -> vec2i {
    total += v;
    return total;
}

fn reset() {
    total = vec2i();
}

fn twice(v: vec2i) {
    add(v);
    add(v);
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let p = vec2i(at.xy);
    add(vec2i(1000, 1));
    reset();
    twice(p);
    add(p.yx);
    return vec4i(total, add(vec2i(1, 2)));
}
