#param c.long: vec3f = (0, 0, 0), color
#param c.short: vec3f = (0, 0, 0), color
#param c.alpha: vec4f = (0, 0, 0, 0), color
#param c.opaque: vec4f = (0, 0, 0, 0), color
#param c.list: vec3f = (0, 0, 0), color

@fragment
fn main() -> @location(0) vec4f {
    return c.alpha + c.opaque + vec4f(c.long + c.short + c.list, 1.0);
}
