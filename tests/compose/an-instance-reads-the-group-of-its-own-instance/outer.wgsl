#include "inner.wgsl" as detail

fn outer() -> f32 {
#if detail.octaves > 2
    return detail.strength * detail_inner();
#else
    return 0.0;
#endif
}
