/// The noise it is made of.
#slot noise2: fn(p: vec2f) -> vec3f

fn fbm2(p: vec2f) -> vec3f {
    return noise2(p);
}
