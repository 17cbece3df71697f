#include <level0.wgsl>
