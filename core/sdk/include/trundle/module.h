// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// Turns a shared library into a module:
//
//     TRUNDLE_MODULE(registry) { registry.controller<WallFollower>("WallFollower"); }
//
// once in one source file. It defines the entry symbol, which returns the tables of the registered kinds.

#include <memory>
#include <string>
#include <vector>

#include <trundle/controller_table.h>
#include <trundle/kind_table.h>

namespace trundle {
inline namespace sdk1 {

/// The kinds of one module.
class ModuleRegistry {
public:
    /// T derives from Controller, has a static describe() and is default-constructible.
    template <class T> void controller(const char* name) { m_tables.push_back(controllerTable<T>(name)); }
    /// T derives from Device.
    template <class T> void device(const char* name) { m_tables.push_back(deviceTable<T>(name)); }

    /// Valid as long as the registry exists.
    [[nodiscard]] const TrundleModule* module() {
        m_kinds.clear();
        for (const auto& table : m_tables) m_kinds.push_back(&table->kind);
        m_module = {TRUNDLE_MAGIC,
                    sizeof(TrundleModule),
                    TRUNDLE_ABI_MAJOR,
                    TRUNDLE_ABI_MINOR,
                    TRUNDLE_SDK_VERSION,
                    m_kinds.data(),
                    static_cast<std::uint32_t>(m_kinds.size()),
                    0};
        return &m_module;
    }
    [[nodiscard]] const std::vector<std::unique_ptr<KindTable>>& tables() const { return m_tables; }

private:
    std::vector<std::unique_ptr<KindTable>> m_tables;
    std::vector<const TrundleKind*> m_kinds;
    TrundleModule m_module{};
};

/// Runs `fill` once; nullptr if it throws, since no exception may leave a module.
inline const TrundleModule* makeModule(ModuleRegistry& registry, void (*fill)(ModuleRegistry&)) {
    try {
        fill(registry);
        return registry.module();
    } catch (...) { return nullptr; }
}

} // namespace sdk1
} // namespace trundle

#if defined(_WIN32)
#define TRUNDLE_EXPORT __declspec(dllexport)
#else
#define TRUNDLE_EXPORT __attribute__((visibility("default")))
#endif

#define TRUNDLE_MODULE(registry)                                                                                                 \
    static void trundleFillModule(::trundle::ModuleRegistry& registry);                                                          \
    extern "C" TRUNDLE_EXPORT const TrundleModule* trundle_module(void) {                                                        \
        static ::trundle::ModuleRegistry kinds;                                                                                  \
        static const TrundleModule* const module = ::trundle::makeModule(kinds, &trundleFillModule);                             \
        return module;                                                                                                           \
    }                                                                                                                            \
    static void trundleFillModule(::trundle::ModuleRegistry& registry)
