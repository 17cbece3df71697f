#option mode = middle { low, middle, high }
#option steps = 16, range 1 .. 64
#option scene.fog = true
#option plain = false

#if mode == low
const A = 1;
#elif steps > 8
const A = 2;
#elif mode == middle
const A = 3;
#else
const A = 4;
#endif

#if mode == low
const B = 1;
#elif mode == high
const B = 2;
#else
const B = 3;
#endif

@fragment fn main() -> @location(0) vec4f {
    return vec4f(f32(A), f32(B), 0, 1);
}
