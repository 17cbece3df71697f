#include <sun.wgsl>
#param layer.cover: f32 = 0.5
#option layer.soft = true

fn light() -> f32 {
#if layer.soft
    return layer.cover * sun.power;
#else
    return 0.0;
#endif
}
