// The position comes in as a member, the colour goes out as one.

struct Input { @builtin(position) place: vec4f }
struct Output { @location(0) color: vec4f }

fn shade(p: vec2u) -> Output {
    var out: Output;
    out.color = vec4f(vec4u(p, p.x * p.y, 7u));
    return out;
}

@fragment
fn main_fragment(in: Input) -> Output {
    if in.place.x < 5.0 { return Output(vec4f(1.0, 2.0, 3.0, 4.0)); }
    return shade(vec2u(in.place.xy));
}
