#include <link.wgsl>
