#include <tree0.wgsl>
