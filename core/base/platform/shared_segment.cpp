#include "base/platform/shared_segment.h"

#include <cerrno>
#include <cstring>
#include <string>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace trundle {
namespace {

Error refused() { return {Code::SystemRefused, std::string("no shared memory: ") + std::strerror(errno)}; }

} // namespace

Result<SharedSegment> SharedSegment::create(const char* name, std::size_t bytes) {
    SharedSegment made;
    made.m_file = ::memfd_create(name, MFD_CLOEXEC | MFD_ALLOW_SEALING);
    if (made.m_file < 0) return refused();
    if (bytes > 0)
        if (const Status sized = made.resize(bytes); !sized) return sized.error();
    return made;
}

Status SharedSegment::resize(std::size_t bytes) {
    if (::ftruncate(m_file, static_cast<off_t>(bytes)) != 0) return refused();
    if (::fcntl(m_file, F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL) != 0) return refused();
    void* data = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, m_file, 0);
    if (data == MAP_FAILED) return refused();
    m_data = data;
    m_bytes = bytes;
    return {};
}

Result<SharedSegment> SharedSegment::map(int descriptor, bool writable) {
    struct stat status = {};
    if (::fstat(descriptor, &status) != 0) return refused();
    SharedSegment made;
    made.m_bytes = static_cast<std::size_t>(status.st_size);
    void* data = ::mmap(nullptr, made.m_bytes, writable ? PROT_READ | PROT_WRITE : PROT_READ, MAP_SHARED, descriptor, 0);
    if (data == MAP_FAILED) return refused();
    made.m_data = data;
    return made;
}

SharedSegment& SharedSegment::operator=(SharedSegment&& other) noexcept {
    std::swap(m_file, other.m_file);
    std::swap(m_readOnly, other.m_readOnly);
    std::swap(m_data, other.m_data);
    std::swap(m_bytes, other.m_bytes);
    return *this;
}

SharedSegment::~SharedSegment() {
    if (m_data) ::munmap(m_data, m_bytes);
    for (const int file : {m_file, m_readOnly})
        if (file >= 0) ::close(file);
}

int SharedSegment::readOnlyDescriptor() {
    if (m_readOnly < 0) m_readOnly = ::open(("/proc/self/fd/" + std::to_string(m_file)).c_str(), O_RDONLY | O_CLOEXEC);
    return m_readOnly;
}

} // namespace trundle
