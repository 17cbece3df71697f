#option mode = middle { low, middle, high }
#option steps = 16, range 1 .. 64
#option scene.fog = true
#option plain = false

const A = array(
#if plain && plain || scene.fog
    1, // (plain && plain) || fog
#endif
#if scene.fog || plain && plain
    2, // fog || (plain && plain)
#endif
#if !(plain || scene.fog)
    0,
#endif
#if !plain && steps > 8 == scene.fog
    3, // (steps > 8) == fog
#endif
#if !!scene.fog
    4,
#endif
#if ((steps)) > ((8)) // comments may follow
    5,
#endif
    6
);

@fragment fn main() -> @location(0) vec4f {
    return vec4f(f32(A[0]));
}
