#param a.v: vec3f = (1, 2, 3)
#param a.v_x: f32 = 1.0
@fragment fn main() -> @location(0) vec4f {
    return vec4f(a.v + a.v_x, 1.0);
}
