fn main_image(p: vec2f) -> vec3f { return vec3f(1.0); }
