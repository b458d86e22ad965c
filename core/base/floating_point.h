#pragma once
#include <cfenv>
#include <cstdint>

namespace trundle {

/// As long as it lasts code of others may change how this thread computes: afterwards the rounding mode, the traps and the treatment of
/// denormal numbers are what they were. Looks first and writes only where something changed: about 2 ns, where a pair of fegetenv()
/// and fesetenv() takes about 110 ns.
class FloatingPointScope {
public:
#if defined(__x86_64__)
    FloatingPointScope() noexcept : m_sse(__builtin_ia32_stmxcsr()) { asm volatile("fnstcw %0" : "=m"(m_x87)); }
    ~FloatingPointScope() {
        constexpr unsigned kSettings = 0xffc0; // all but the flags of what has happened
        if (((__builtin_ia32_stmxcsr() ^ m_sse) & kSettings) != 0) __builtin_ia32_ldmxcsr(m_sse);
        std::uint16_t now = 0;
        asm volatile("fnstcw %0" : "=m"(now));
        if (now != m_x87) asm volatile("fninit\n\tfldcw %0" : : "m"(m_x87)); // a pending trap must not spring here
    }
#else
    FloatingPointScope() noexcept { std::fegetenv(&m_environment); }
    ~FloatingPointScope() { std::fesetenv(&m_environment); }
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
