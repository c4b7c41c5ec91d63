// An extension module has a function of this name, which tools that build one look for. The library
// is loaded by ctypes instead, so that one build serves every version of Python.

#include "kernels.h"

EXPORTED void *PyInit__kernels() { return nullptr; }
