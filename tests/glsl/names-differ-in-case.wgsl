// Upper and lower case are different names; a structure may be called like a variable but for its case.

struct Ray { Length: f32, length: f32 }

fn Trace(ray: Ray) -> f32 {
    let RAY = ray.Length;
    let Ray_ = ray.length * 10.0;
    return RAY + Ray_;
}

fn trace(Ray: f32) -> f32 {
    return Ray * 2.0;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let ray = Ray(floor(at.x), floor(at.y));
    let Float = 2.0;
    let FLOAT = 3.0;
    return vec4f(Trace(ray), trace(Float), FLOAT, 0.0);
}
