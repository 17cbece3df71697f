#include <odd.wgsl>
const EVEN = 2 * HALF;
