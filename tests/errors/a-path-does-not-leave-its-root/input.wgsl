#include <../../etc/passwd>
#include "../../etc/passwd"
#include </etc/passwd>
#include "/etc/passwd"
#include <a/../../b.wgsl>
#include <c:\windows>
#include <>
#include "."
