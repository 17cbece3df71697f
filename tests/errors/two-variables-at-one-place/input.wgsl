@group(0) @binding(0) var picture: texture_2d<f32>;

fn main_image(frag_coord: vec2f) -> vec4f {
    return textureLoad(picture, vec2i(frag_coord), 0);
}
