// Members called like types, functions, keywords of GLSL, swizzles, and the structure itself.

struct Odd {
    x: f32,
    xyz: f32,
    input: i32,
    float: f32,
    vec3: vec3f,
    sample: u32,
    mix: f32,
    length: i32,
    Odd: f32,
    out: vec2f,
    gl_Position: f32,
    double__underscore: f32,
    main: f32,
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    var o = Odd();
    o.x = floor(at.x);
    o.xyz = o.x + 1.0;
    o.input = i32(at.y);
    o.float = 2.5;
    o.vec3 = vec3f(o.x, o.xyz, o.float);
    o.sample = 7u;
    o.mix = mix(o.x, o.xyz, 0.5);
    o.length = o.input + 3;
    o.Odd = f32(o.length);
    o.out.x += length(vec2f(3.0, 4.0));
    o.gl_Position = 0.25;
    o.double__underscore = 0.125;
    o.main = 1000.0;
    return vec4f(o.vec3.xyz, o.mix) + vec4f(f32(o.sample), o.Odd, o.out.x, o.gl_Position + o.double__underscore + o.main);
}
