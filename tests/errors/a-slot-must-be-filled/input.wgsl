#include <fbm.wgsl> as relief
