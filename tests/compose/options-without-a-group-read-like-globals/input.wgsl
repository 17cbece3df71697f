#option quality = 3, range 1 .. 4

fn a(quality_like: i32) -> i32 { return quality * quality_like; }

@fragment fn main() -> @location(0) vec4f {
    return vec4f(f32(a(quality)));
}
