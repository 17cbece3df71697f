// An override without a host to set it, alone and in expressions of others.

override steps: i32 = 5;
override scale: f32 = 0.5;
override doubled = scale * 2.0 + f32(steps);
@id(7) override enabled: bool = true;
override mask: u32 = 0xF0u;

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    var sum = 0.0;
    for (var i = 0; i < steps; i++) { sum += scale * floor(at.x); }
    if enabled { sum += 1.0; }
    return vec4f(sum, doubled, f32(mask & u32(at.y)), select(0.0, 1.0, enabled));
}
