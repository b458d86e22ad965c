#include <trundle/module.h>
extern "C" TRUNDLE_EXPORT const TrundleModule* trundle_module(void) {
    static const TrundleModule module{
        TRUNDLE_MAGIC, sizeof(TrundleModule), TRUNDLE_ABI_MAJOR, TRUNDLE_ABI_MINOR + 1, "1.99.0", nullptr, 0, 0};
    return &module;
}
