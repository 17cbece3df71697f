#include <folder>
