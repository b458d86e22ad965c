#include "base/platform/dynamic_library.h"

#include <utility>

#include <dlfcn.h>

namespace trundle {

Result<DynamicLibrary> DynamicLibrary::open(const std::string& path) {
    if (path.find('/') == std::string::npos) return Error{Code::ModuleUnreadable, path + ": a library needs a path with a slash"};
    ::dlerror(); // forget an older fault
    void* handle = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle == nullptr) {
        const char* words = ::dlerror();
        std::string why = words != nullptr ? words : path + ": the loader gives no reason";
        const bool missing = why.find("undefined symbol") != std::string::npos;
        return Error{missing ? Code::ModuleMissingSymbol : Code::ModuleUnreadable, std::move(why)};
    }
    DynamicLibrary library;
    library.m_handle = handle;
    library.m_path = path;
    return library;
}

DynamicLibrary::DynamicLibrary(DynamicLibrary&& other) noexcept
    : m_handle(std::exchange(other.m_handle, nullptr)), m_keep(other.m_keep), m_path(std::move(other.m_path)) {}

DynamicLibrary& DynamicLibrary::operator=(DynamicLibrary&& other) noexcept {
    if (this == &other) return *this;
    close();
    m_handle = std::exchange(other.m_handle, nullptr);
    m_keep = other.m_keep;
    m_path = std::move(other.m_path);
    return *this;
}

void* DynamicLibrary::symbol(const char* name) const { return m_handle != nullptr ? ::dlsym(m_handle, name) : nullptr; }

void DynamicLibrary::close() {
    void* handle = std::exchange(m_handle, nullptr);
    if (handle != nullptr && !m_keep) ::dlclose(handle);
}

} // namespace trundle
