// GLSL's preprocessor knows these names; WebGL reserves others by their beginning.

const GL_ES = 2.0;
const GL_FRAGMENT_PRECISION_HIGH = 3.0;
const defined = 4.0;
var<private> webgl_seed: f32 = 5.0;

struct GL_EXT_color_buffer_float { _webgl_a: f32, line: f32 }

fn _webgl_noise(webgl_x: f32) -> f32 {
    return webgl_x + 1.0;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let VERSION = floor(at.x);
    let GL_OES_standard_derivatives = GL_EXT_color_buffer_float(VERSION, 1.0);
    let line = 8.0;
    let version = GL_OES_standard_derivatives.line + line;
    let define = version * GL_ES;
    let pragma = _webgl_noise(GL_OES_standard_derivatives._webgl_a);
    webgl_seed += GL_FRAGMENT_PRECISION_HIGH;
    return vec4f(define, pragma, webgl_seed, defined);
}
