#include <a.wgsl>
#include <b.wgsl>
#include <shared.wgsl>

@fragment fn main() -> @location(0) vec4f {
    return vec4f(a() + b() + shared_value());
}
