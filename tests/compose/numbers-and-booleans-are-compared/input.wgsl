#option mode = middle { low, middle, high }
#option steps = 16, range 1 .. 64
#option scene.fog = true
#option plain = false

const A = array(
#if steps >= 16 && steps <= 16
    1,
#endif
#if steps > 15.5
    2,
#endif
#if steps == 16.0
    3,
#endif
#if steps > -1
    4,
#endif
#if scene.fog
    5,
#endif
#if !plain
    6,
#endif
#if scene.fog != plain
    7,
#endif
#if scene.fog == true
    8,
#endif
#if false || steps < 2
    0,
#endif
    9
);

@fragment fn main() -> @location(0) vec4f {
    return vec4f(f32(A[0]));
}
