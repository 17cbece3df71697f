// What Shadertoy puts before a shader, and what it calls.

const iResolution = 3.0;
var<private> iTime: f32 = 2.0;

struct iMouse { x: f32, iFrame: i32 }

fn mainImage(fragCoord: vec2f) -> f32 {
    let fragColor = fragCoord.x * iResolution;
    return fragColor;
}

fn main(iDate: f32) -> f32 {
    return iDate + 1.0;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let iTimeDelta = 0.5;
    let iChannel0 = floor(at.xy);
    let iSampleRate = iMouse(iChannel0.x, 7);
    let iFrame = iSampleRate.iFrame;
    let iFrameRate = main(iTimeDelta);
    iTime += 1.0;
    return vec4f(mainImage(iChannel0), iTime + iFrameRate, iSampleRate.x, f32(iFrame));
}
