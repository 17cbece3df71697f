#option mode = middle { low, middle, high }
#option steps = 16, range 1 .. 64
#option scene.fog = true
#option plain = false

#if plain
    #if scene.fog
const A = 0;
    #else
const A = 1;
    #endif
const LOST = 1;
#else
    #if scene.fog
        #if mode == middle
const A = 2;
        #elif true
const A = 3;
        #endif
    #endif
#endif

@fragment fn main() -> @location(0) vec4f {
    return vec4f(f32(A));
}
