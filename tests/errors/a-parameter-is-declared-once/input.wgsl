#include <sun.wgsl>
#param sun.power: f32 = 1.0
#option sun.power = true
