#include "tow.wgsl"
#include <b/tow.wgsl>
#include <b/tow.wgsl> as again
