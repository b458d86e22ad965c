#include "base/platform/next_symbol.h"

#include <dlfcn.h>

namespace trundle {

void* nextSymbol(const char* name) { return ::dlsym(RTLD_NEXT, name); }

} // namespace trundle
