#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"

namespace trundle {

/// A shared library loaded into this process. Loading runs its static constructors, so check the file first.
class DynamicLibrary {
public:
    /// Loads with RTLD_NOW and RTLD_LOCAL. Fails with the loader's message: ModuleMissingSymbol for an undefined symbol,
    /// otherwise ModuleUnreadable. `path` must contain a slash, so that no search path is used.
    [[nodiscard]] static Result<DynamicLibrary> open(const std::string& path);
    /// Loads `bytes`, read before from `path`, from private memory: later writes to the file have no effect, and the same file
    /// opened again is a separate library. `$ORIGIN` does not work in it.
    [[nodiscard]] static Result<DynamicLibrary> openCopy(const std::string& path, std::string_view bytes);

    DynamicLibrary() = default;
    DynamicLibrary(DynamicLibrary&& other) noexcept;
    DynamicLibrary& operator=(DynamicLibrary&& other) noexcept;
    ~DynamicLibrary() { close(); }

    [[nodiscard]] bool loaded() const { return m_handle != nullptr; }
    [[nodiscard]] const std::string& path() const { return m_path; }
    /// nullptr if the library has no such symbol.
    [[nodiscard]] void* symbol(const char* name) const;
    template <class Function> [[nodiscard]] Function* function(const char* name) const {
        return reinterpret_cast<Function*>(symbol(name));
    }

    /// The difference between its addresses in memory and in the file; 0 if unknown.
    [[nodiscard]] std::uintptr_t base() const;
    /// The address ranges [first, second) of its machine code.
    [[nodiscard]] std::vector<std::pair<std::uintptr_t, std::uintptr_t>> code() const;

    /// Prevents close() and the destructor from unloading it, because its code may still be in use on a stack or in a table.
    void keepLoaded() { m_keep = true; }
    void close();

private:
    void* m_handle = nullptr;
    int m_copy = -1; // memfd; -1: none
    bool m_keep = false;
    std::string m_path;
};

} // namespace trundle
