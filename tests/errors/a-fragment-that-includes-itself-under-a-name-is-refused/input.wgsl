#include "input.wgsl" as deeper
