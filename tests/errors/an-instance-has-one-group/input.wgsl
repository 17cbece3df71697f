#include <mixed.wgsl> as my
