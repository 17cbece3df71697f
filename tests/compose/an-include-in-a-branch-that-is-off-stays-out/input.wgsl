#option mode = middle { low, middle, high }
#option steps = 16, range 1 .. 64
#option scene.fog = true
#option plain = false
#if mode == high
#include <high.wgsl>
#else
#include <low.wgsl>
#endif

@fragment fn main() -> @location(0) vec4f {
    return vec4f(value());
}
