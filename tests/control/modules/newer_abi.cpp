#include <trundle/module.h>
extern "C" TRUNDLE_EXPORT const TrundleModule* trundle_module(void) {
    static const TrundleModule module{TRUNDLE_MAGIC, sizeof(TrundleModule), TRUNDLE_ABI_MAJOR + 1, 3, "2.3.0", nullptr, 0, 0};
    return &module;
}
