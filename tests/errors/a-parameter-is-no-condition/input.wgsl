#include <sun.wgsl>
#if sun.elevation > 10
#endif
