#include <a/one.wgsl>
