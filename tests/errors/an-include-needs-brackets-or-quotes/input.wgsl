#include noise.wgsl
#include <noise.wgsl
#include "noise.wgsl> as x
#include <a.wgsl> as
#include <a.wgsl> as 2x
#include <a.wgsl> with noise
#include <a.wgsl> with noise =
#include <a.wgsl> as _x
#include <a.wgsl> of b
