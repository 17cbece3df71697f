// `+=` and its kin on f32, i32 and u32.

@fragment
fn main_fragment(@builtin(position) at: vec4f) -> @location(0) vec4i {
    var f = floor(at.x);
    f += 1.5;
    f -= 0.25;
    f *= 2;
    f /= 4.0;
    f %= 3.0;
    var i = i32(at.x) - 32;
    i += 5;
    i -= 2;
    i *= -3;
    i /= 2;
    i %= 7;
    i |= 1;
    i &= 0xFF;
    i ^= 0x55;
    i <<= 3u;
    i >>= 1u;
    var u = u32(at.y);
    u += 1u;
    u -= 2u;
    u *= 3u;
    u /= 5u;
    u %= 1000u;
    u |= 8u;
    u &= ~1u;
    u ^= 12u;
    u <<= 2u;
    u >>= 3u;
    return vec4i(i32(f * 64.0), i, i32(u), 0);
}
