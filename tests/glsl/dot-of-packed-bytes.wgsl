// dot4U8Packed and dot4I8Packed: four bytes against four.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    let a = u32(at.x) * 0x9E3779B9u;
    let b = u32(at.y) * 0x85EBCA6Bu + 1u;
    return vec4i(i32(dot4U8Packed(a, b)), dot4I8Packed(a, b), i32(dot4U8Packed(a, a)), dot4I8Packed(b, 0x80808080u));
}
