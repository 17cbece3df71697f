#include "missing.wgsl"
