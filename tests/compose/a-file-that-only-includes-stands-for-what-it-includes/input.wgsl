#include "a.wgsl"
#include "b.wgsl"
