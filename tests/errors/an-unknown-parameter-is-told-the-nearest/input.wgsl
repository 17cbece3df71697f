#include <sun.wgsl>
@fragment fn main() -> @location(0) vec4f {
    return vec4f(sun.elevatoin + sun.quite_unlike + sun.elevatoin);
}
