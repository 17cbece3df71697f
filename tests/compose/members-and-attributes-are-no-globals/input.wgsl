#include <lib.wgsl> as my

@fragment fn main() -> @location(0) vec4f {
    return vec4f(my_f(my_S(1.0, 2.0)));
}
