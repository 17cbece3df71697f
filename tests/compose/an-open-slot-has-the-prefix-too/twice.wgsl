#include <inner.wgsl> as inner with step1 = step2

#slot step2: fn(x: f32) -> f32

/// Two steps.
fn twice(x: f32) -> f32 {
    return step2(inner_once(x));
}
