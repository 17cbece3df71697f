struct OrogenParams { x: f32 }
@group(0) @binding(0) var<uniform> orogen: OrogenParams;

@fragment fn main() -> @location(0) vec4f {
    return vec4f(orogen.x);
}
