#include <all.wgsl>
