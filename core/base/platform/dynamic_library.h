#pragma once
#include <string>

#include "base/result.h"

namespace trundle {

/// A shared library opened into this process. Opening runs the library's static constructors: look at the file before.
class DynamicLibrary {
public:
    /// All symbols bound at once, none shown to other libraries. Fails with the loader's own words: ModuleMissingSymbol where
    /// one is undefined, else ModuleUnreadable. `path` must hold a slash, so that no search path is asked.
    [[nodiscard]] static Result<DynamicLibrary> open(const std::string& path);

    DynamicLibrary() = default;
    DynamicLibrary(DynamicLibrary&& other) noexcept;
    DynamicLibrary& operator=(DynamicLibrary&& other) noexcept;
    ~DynamicLibrary() { close(); }

    [[nodiscard]] bool loaded() const { return m_handle != nullptr; }
    [[nodiscard]] const std::string& path() const { return m_path; }
    /// nullptr where the library has no such symbol.
    [[nodiscard]] void* symbol(const char* name) const;
    template <class Function> [[nodiscard]] Function* function(const char* name) const {
        return reinterpret_cast<Function*>(symbol(name));
    }

    /// From now on neither close() nor the destructor unloads it: its code may still be on some stack or in some table.
    void keepLoaded() { m_keep = true; }
    void close();

private:
    void* m_handle = nullptr;
    bool m_keep = false;
    std::string m_path;
};

} // namespace trundle
