#include <even.wgsl>
#include <odd.wgsl>
const HALF = 3;
const WHOLE = EVEN;
