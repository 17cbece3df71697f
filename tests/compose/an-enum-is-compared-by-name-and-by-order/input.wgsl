#option mode = middle { low, middle, high }
#option steps = 16, range 1 .. 64
#option scene.fog = true
#option plain = false

const A = array(
#if mode == middle
    1,
#endif
#if mode != low
    2,
#endif
#if mode < high
    3,
#endif
#if low < mode
    4,
#endif
#if mode >= high
    0,
#endif
    5
);

@fragment fn main() -> @location(0) vec4f {
    return vec4f(f32(A[0]));
}
