#include <bytes.wgsl>
