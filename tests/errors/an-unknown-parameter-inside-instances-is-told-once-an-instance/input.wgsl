#include <layer.wgsl> as high
#include <layer.wgsl> as low
