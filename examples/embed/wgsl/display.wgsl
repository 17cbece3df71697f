// The engine's last pass: its picture of light, brought onto a display. Nothing here is Orogen's.

struct Display {
    /// Factor on all light.
    exposure: f32,
    /// Samples a pixel, each way.
    samples: u32,
    /// Side of the blocks of pixels that share a sample.
    block: u32,
}

@group(0) @binding(0) var light: texture_2d<f32>;
@group(0) @binding(1) var<uniform> display: Display;

@vertex
fn display_vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return vec4f(vec2f(f32(index & 1u), f32(index >> 1u)) * 4.0 - 1.0, 0.0, 1.0);
}

@fragment
fn display_fragment(@builtin(position) pixel: vec4f) -> @location(0) vec4f {
    let first = vec2u(pixel.xy) / display.block * display.samples;
    var shown = vec3f(0.0);
    for (var y = 0u; y < display.samples; y++) {
        for (var x = 0u; x < display.samples; x++) {
            let radiance = textureLoad(light, first + vec2u(x, y), 0).rgb;
            shown += 1.0 - exp(-display.exposure * clamp(radiance, vec3f(0.0), vec3f(6e4)));
        }
    }
    return vec4f(shown / f32(display.samples * display.samples), 1.0);
}
