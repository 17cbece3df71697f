fn main_image(frag_coord: vec2f) -> vec3f {
    return vec3f(frag_coord, 0.0);
}
