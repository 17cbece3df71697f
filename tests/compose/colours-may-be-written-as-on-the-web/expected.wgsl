// ---- c ----
const c_long: vec3f = vec3f(1.0, 0.2158605, 0.0);
const c_short: vec3f = vec3f(1.0, 0.0, 0.0);
const c_alpha: vec4f = vec4f(1.0, 1.0, 1.0, 0.5019608);
const c_opaque: vec4f = vec4f(1.0, 1.0, 1.0, 1.0);
const c_list: vec3f = vec3f(1.0, 0.5, 0.0);

// ---- tests/compose/colours-may-be-written-as-on-the-web/scene.wgsl ----
@fragment
fn main() -> @location(0) vec4f {
    return c_alpha + c_opaque + vec4f(c_long + c_short + c_list, 1.0);
}
