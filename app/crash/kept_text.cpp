#include "crash/kept_text.h"

#include <cstring>
#include <utility>

#include <sys/mman.h>

namespace trundle {
namespace {

constexpr std::size_t kPage = 4096;

} // namespace

KeptText::KeptText(std::string_view text) {
    if (text.empty()) return;
    const std::size_t inner = (text.size() + kPage - 1) / kPage * kPage, all = inner + 2 * kPage;
    void* const pages = mmap(nullptr, all, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (pages == MAP_FAILED) return;
    char* const begin = static_cast<char*>(pages) + kPage;
    m_text = begin;
    m_mapped = all;
    if (mprotect(begin, inner, PROT_READ | PROT_WRITE) != 0) return;
    std::memcpy(begin, text.data(), text.size());
    (void)mprotect(begin, inner, PROT_READ);
    m_size = text.size();
}

KeptText::~KeptText() {
    if (m_mapped > 0) munmap(const_cast<char*>(m_text) - kPage, m_mapped);
}

void KeptText::swap(KeptText& other) noexcept {
    std::swap(m_text, other.m_text);
    std::swap(m_size, other.m_size);
    std::swap(m_mapped, other.m_mapped);
}

} // namespace trundle
