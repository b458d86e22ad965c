#include "base/platform/module_text.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include <link.h>
#include <pthread.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace trundle {
namespace {

constexpr std::size_t kLongestName = 4096, kLongestWords = 8u << 20, kShownOfName = 32;

/// Asks the kernel whether a byte is readable, since reading it directly could crash. Method: a call that reads eight bytes and then
/// fails, as no signal mask is changed in a way that is not one; much cheaper than reading memory as another process would.
bool isReadable(const char* byte) {
    constexpr std::uintptr_t kBytes = 8;
    const std::uintptr_t from = reinterpret_cast<std::uintptr_t>(byte) / kBytes * kBytes; // all in one page
    return syscall(SYS_rt_sigprocmask, -1, from, nullptr, kBytes) == 0 || errno != EFAULT;
}

/// The program itself, which stays where it is: texts of built-in kinds need not be asked for.
class ProgramImage {
public:
    ProgramImage() {
        dl_iterate_phdr(
            [](dl_phdr_info* info, std::size_t, void* self) {
                for (int i = 0; i < info->dlpi_phnum; ++i)
                    static_cast<ProgramImage*>(self)->add(info->dlpi_phdr[i], info->dlpi_addr);
                return 1; // the first is the program
            },
            this);
    }
    [[nodiscard]] bool has(const char* byte) const {
        const auto at = reinterpret_cast<std::uintptr_t>(byte);
        for (int i = 0; i < m_count; ++i)
            if (at >= m_parts[i].from && at < m_parts[i].to) return true;
        return false;
    }

private:
    void add(const ElfW(Phdr) & part, std::uintptr_t base) {
        if (part.p_type != PT_LOAD || (part.p_flags & PF_R) == 0 || m_count == kMost) return;
        m_parts[m_count++] = {base + part.p_vaddr, base + part.p_vaddr + part.p_memsz};
    }

    static constexpr int kMost = 8;
    struct Part {
        std::uintptr_t from = 0, to = 0;
    } m_parts[kMost];
    int m_count = 0;
};

/// What of the calling thread's stack is in use.
bool isOnStack(const char* byte) {
    thread_local const char* const end = [] {
        pthread_attr_t attributes;
        void* from = nullptr;
        std::size_t size = 0;
        if (pthread_getattr_np(pthread_self(), &attributes) != 0) return static_cast<const char*>(nullptr);
        const bool found = pthread_attr_getstack(&attributes, &from, &size) == 0;
        pthread_attr_destroy(&attributes);
        return found ? static_cast<const char*>(from) + size : nullptr;
    }();
    return byte >= static_cast<const char*>(__builtin_frame_address(0)) && byte < end;
}

/// The memory that malloc takes from the end of the program's data; it grows and shrinks at its end only.
bool isOnHeap(const char* byte) {
    static const char* const begin = [] {
        std::ifstream maps("/proc/self/maps");
        for (std::string line; std::getline(maps, line);)
            if (line.ends_with("[heap]")) return reinterpret_cast<const char*>(std::strtoull(line.c_str(), nullptr, 16));
        return static_cast<const char*>(nullptr);
    }();
    return begin && byte >= begin && byte < static_cast<const char*>(sbrk(0));
}

struct Span {
    std::size_t length = 0;
    bool terminated = false;
};

/// Scans page by page: within one page all bytes are readable or none.
Span spanOf(const char* text, std::size_t longest) {
    static const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    static const ProgramImage program;
    const auto canRead = [](const char* byte) { return program.has(byte) || isOnStack(byte) || isOnHeap(byte) || isReadable(byte); };
    Span span;
    while (span.length < longest && canRead(text + span.length)) {
        const std::size_t toItsEnd = page - reinterpret_cast<std::uintptr_t>(text + span.length) % page;
        const std::size_t count = std::min(toItsEnd, longest - span.length), found = strnlen(text + span.length, count);
        span.length += found;
        if (found < count) {
            span.terminated = true;
            break;
        }
    }
    return span;
}

} // namespace

std::optional<std::size_t> moduleTextLength(const char* text, std::size_t longest) {
    if (!text) return std::nullopt;
    const Span span = spanOf(text, longest);
    return span.terminated ? std::optional(span.length) : std::nullopt;
}

std::string moduleName(const char* name) {
    if (!name) return {};
    const Span span = spanOf(name, kLongestName);
    if (span.terminated) return {name, span.length};
    return std::string(name, std::min(span.length, kShownOfName)) + "… (a name without a terminating zero byte)";
}

std::string moduleMessage(const char* text) {
    if (!text) return {};
    return {text, spanOf(text, kLongestWords).length};
}

} // namespace trundle
