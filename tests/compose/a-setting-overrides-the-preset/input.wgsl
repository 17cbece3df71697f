#param a.x: f32 = 1.0
#param a.v: vec3f = (0, 0, 0)
#option mode = low { low, high }
#option on = true

@fragment
fn main() -> @location(0) vec4f {
#if mode == high && !on
    return vec4f(a.v, a.x);
#else
    return vec4f(0.0);
#endif
}
