#include <large.wgsl>
