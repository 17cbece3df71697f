#include "b.wgsl"
