#include <trundle/module.h>
extern "C" int trundle_test_missing_symbol(void);
extern "C" TRUNDLE_EXPORT const TrundleModule* trundle_module(void) {
    static const TrundleModule module{TRUNDLE_MAGIC,
                                      sizeof(TrundleModule),
                                      TRUNDLE_ABI_MAJOR,
                                      static_cast<uint32_t>(trundle_test_missing_symbol()),
                                      "1.0.0",
                                      nullptr,
                                      0,
                                      0};
    return &module;
}
