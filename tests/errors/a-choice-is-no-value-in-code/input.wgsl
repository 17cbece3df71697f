#option a.mode = low { low, high }
#option kind = one { one, two }
@fragment fn main() -> @location(0) vec4f {
    return vec4f(f32(a.mode + kind));
}
