// A structure in a structure, built by name, read and written member by member, copied by value.

struct Ray {
    origin: vec3f,
    direction: vec3f,
}

struct Hit {
    /// How far.
    distance: f32,
    ray: Ray, // where from
    kind: u32,
};

fn advance(hit: Hit) -> Hit {
    var next = hit;
    next.distance += 1.0;
    next.ray.origin += hit.ray.direction * hit.distance;
    next.kind = hit.kind + 1u;
    return next;
}

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let p = floor(at.xy);
    let start = Hit(2.0, Ray(vec3f(p, 1.0), vec3f(1.0, p.y, -1.0)), 7u);
    var hit = advance(start);
    let kept = hit;
    hit.ray.direction.y = 100.0;
    hit = advance(hit);
    return vec4f(hit.ray.origin, hit.distance) + vec4f(kept.ray.direction, f32(hit.kind + start.kind));
}
