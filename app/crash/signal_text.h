#pragma once
#include <cstdint>

namespace trundle {

/// Writes text to a file descriptor without heap memory, locks or the locale, for use in signal handlers.
class SignalText {
public:
    explicit SignalText(int file) : m_file(file) {}
    ~SignalText() { flush(); }
    SignalText(const SignalText&) = delete;
    SignalText& operator=(const SignalText&) = delete;

    SignalText& add(const char* text);
    SignalText& add(const char* bytes, std::uint64_t count);
    SignalText& add(std::uint64_t number);
    SignalText& add(double number); ///< non-negative, with at most six decimals
    /// Replaces control characters (see isControl()) and invalid UTF-8 by '?'. `json`: escaped for the inside of a JSON string.
    SignalText& addClean(const char* text, bool json = false);
    /// A JSON string, cleaned in the same way. nullptr and "" become null.
    SignalText& addJson(const char* text);
    void flush();

private:
    void put(char c);

    int m_file;
    std::uint32_t m_held = 0;
    char m_bytes[1024];
};

} // namespace trundle
