#include "base/platform/dynamic_library.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include <dlfcn.h>
#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

namespace trundle {
namespace {

constexpr unsigned kExecutable = 0x10; // MFD_EXEC, missing in older headers

Result<void*> opened(const std::string& path) {
    ::dlerror(); // clear an earlier error
    if (void* handle = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL)) return handle;
    const char* words = ::dlerror();
    std::string why = words != nullptr ? words : path + ": the loader gives no reason";
    const bool missing = why.find("undefined symbol") != std::string::npos;
    return Error{missing ? Code::ModuleMissingSymbol : Code::ModuleUnreadable, std::move(why)};
}

/// A private copy in memory (memfd); -1 with errno on failure.
int fileOf(const std::string& path, std::string_view bytes) {
    const std::string name = path.substr(path.rfind('/') + 1).substr(0, 200);
    int file = ::memfd_create(name.c_str(), MFD_CLOEXEC | kExecutable);
    if (file < 0 && errno == EINVAL) file = ::memfd_create(name.c_str(), MFD_CLOEXEC); // a kernel without MFD_EXEC
    while (file >= 0 && !bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
        else if (errno != EINTR) ::close(std::exchange(file, -1));
    }
    return file;
}

/// Uses the process id, not "self": debuggers read symbols through this path.
std::string nameOf(int file) { return "/proc/" + std::to_string(::getpid()) + "/fd/" + std::to_string(file); }

} // namespace

Result<DynamicLibrary> DynamicLibrary::open(const std::string& path) {
    if (path.find('/') == std::string::npos) return Error{Code::ModuleUnreadable, path + ": a library needs a path with a slash"};
    const Result<void*> handle = opened(path);
    if (!handle) return handle.error();
    DynamicLibrary library;
    library.m_handle = handle.value();
    library.m_path = path;
    return library;
}

Result<DynamicLibrary> DynamicLibrary::openCopy(const std::string& path, std::string_view bytes) {
    DynamicLibrary library;
    library.m_path = path;
    library.m_copy = fileOf(path, bytes);
    if (library.m_copy < 0) return Error{Code::ModuleUnreadable, path + ": no copy in memory: " + std::strerror(errno)};
    const std::string name = nameOf(library.m_copy);
    const Result<void*> handle = opened(name);
    if (handle) {
        library.m_handle = handle.value();
        return library;
    }
    Error error = handle.error(); // names the original file instead of the copy
    if (const std::size_t at = error.message.find(name); at != std::string::npos) error.message.replace(at, name.size(), path);
    return error;
}

DynamicLibrary::DynamicLibrary(DynamicLibrary&& other) noexcept
    : m_handle(std::exchange(other.m_handle, nullptr)), m_copy(std::exchange(other.m_copy, -1)), m_keep(other.m_keep),
      m_path(std::move(other.m_path)) {}

DynamicLibrary& DynamicLibrary::operator=(DynamicLibrary&& other) noexcept {
    if (this == &other) return *this;
    close();
    m_handle = std::exchange(other.m_handle, nullptr);
    m_copy = std::exchange(other.m_copy, -1);
    m_keep = other.m_keep;
    m_path = std::move(other.m_path);
    return *this;
}

void* DynamicLibrary::symbol(const char* name) const { return m_handle != nullptr ? ::dlsym(m_handle, name) : nullptr; }

std::uintptr_t DynamicLibrary::base() const {
    link_map* map = nullptr;
    return m_handle != nullptr && ::dlinfo(m_handle, RTLD_DI_LINKMAP, &map) == 0 ? map->l_addr : 0;
}

std::vector<std::pair<std::uintptr_t, std::uintptr_t>> DynamicLibrary::code() const {
    struct Search {
        link_map* map = nullptr;
        std::vector<std::pair<std::uintptr_t, std::uintptr_t>> found;
    } search;
    if (m_handle == nullptr || ::dlinfo(m_handle, RTLD_DI_LINKMAP, &search.map) != 0) return {};
    const auto look = [](dl_phdr_info* info, std::size_t, void* data) {
        auto& wanted = *static_cast<Search*>(data);
        if (info->dlpi_addr != wanted.map->l_addr || std::strcmp(info->dlpi_name, wanted.map->l_name) != 0) return 0;
        for (int i = 0; i < info->dlpi_phnum; ++i) {
            const auto& segment = info->dlpi_phdr[i];
            const std::uintptr_t begin = info->dlpi_addr + segment.p_vaddr;
            if (segment.p_type == PT_LOAD && (segment.p_flags & PF_X) != 0)
                wanted.found.emplace_back(begin, begin + segment.p_memsz);
        }
        return 1;
    };
    ::dl_iterate_phdr(look, &search);
    return search.found;
}

void DynamicLibrary::close() {
    void* handle = std::exchange(m_handle, nullptr);
    const int copy = std::exchange(m_copy, -1);
    if (handle != nullptr && m_keep) return;
    if (handle != nullptr) ::dlclose(handle);
    if (copy < 0) return;
    // A library may stay loaded after dlclose. Until it is unloaded no other file may get its name, because the loader would
    // reuse the loaded one.
    void* stays = handle != nullptr ? ::dlopen(nameOf(copy).c_str(), RTLD_LAZY | RTLD_NOLOAD) : nullptr;
    if (stays != nullptr) ::dlclose(stays);
    else ::close(copy);
}

} // namespace trundle
