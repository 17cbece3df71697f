// Double underscores and `gl_` are GLSL's own; leading and trailing underscores are not.

const gl_Scale = 2.0;
const a__b = 3.0;
const a_b = 5.0;
const gl_ = 0.5;

struct gl_Light { power__full: f32, gl_kind: f32, last_: f32 }

fn gl_power(_x: f32, x_: f32) -> f32 {
    return _x * gl_Scale + x_;
}

fn two__three(x: f32) -> f32 {
    let x__ = x + 1.0;
    let x_ = x__ * 2.0;
    let _x_ = x_ + x__;
    return _x_;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let p = floor(at.xy);
    let gl_FragCoord = p.x + a__b;
    let gl_FragColor = p.y * a_b;
    let light = gl_Light(gl_FragCoord, gl_FragColor, gl_);
    return vec4f(gl_power(p.x, 1.0), two__three(p.y), light.power__full + light.gl_kind, light.last_);
}
