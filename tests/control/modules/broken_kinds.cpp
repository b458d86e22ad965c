#include <trundle/module.h>
extern "C" TRUNDLE_EXPORT const TrundleModule* trundle_module(void) {
    static const TrundleKind kind = [] {
        TrundleKind k{};
        k.size = sizeof k;
        k.role = TRUNDLE_CONTROLLER;
        k.name = "Hollow";
        k.help = "";
        return k;
    }();
    static const TrundleKind* const kinds[] = {&kind};
    static const TrundleModule module{
        TRUNDLE_MAGIC, sizeof(TrundleModule), TRUNDLE_ABI_MAJOR, TRUNDLE_ABI_MINOR, "1.0.0", kinds, 1, 0};
    return &module;
}
