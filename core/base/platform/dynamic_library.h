#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"

namespace trundle {

/// A shared library opened into this process. Opening runs the library's static constructors: look at the file before.
class DynamicLibrary {
public:
    /// All symbols bound at once, none shown to other libraries. Fails with the loader's own words: ModuleMissingSymbol where
    /// one is undefined, else ModuleUnreadable. `path` must hold a slash, so that no search path is asked.
    [[nodiscard]] static Result<DynamicLibrary> open(const std::string& path);
    /// The same for `bytes`, which were read from `path`, in memory of this process alone: whoever writes to the file changes nothing
    /// of it, and the file opened once more is another library. `$ORIGIN` in it leads nowhere.
    [[nodiscard]] static Result<DynamicLibrary> openCopy(const std::string& path, std::string_view bytes);

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

    /// Where its machine code is in memory, from the first address up to the second.
    [[nodiscard]] std::vector<std::pair<std::uintptr_t, std::uintptr_t>> code() const;

    /// From now on neither close() nor the destructor unloads it: its code may still be on some stack or in some table.
    void keepLoaded() { m_keep = true; }
    void close();

private:
    void* m_handle = nullptr;
    int m_copy = -1; // file in memory; -1: none
    bool m_keep = false;
    std::string m_path;
};

} // namespace trundle
