#option debug = false

fn main_image(frag_coord: vec2f) -> vec4f {
    return vec4f(frag_coord, 0.0, 1.0);
}

#if debug
@compute @workgroup_size(1)
fn probe() {}
#endif
