#pragma once
#include <cstdint>

namespace trundle {

/// Text for a descriptor, put together without memory of the heap, without locks and without the locale: for signal handlers.
class SignalText {
public:
    explicit SignalText(int file) : m_file(file) {}
    ~SignalText() { flush(); }
    SignalText(const SignalText&) = delete;
    SignalText& operator=(const SignalText&) = delete;

    SignalText& add(const char* text);
    SignalText& add(const char* bytes, std::uint64_t count);
    SignalText& add(std::uint64_t number);
    SignalText& add(double number); ///< from 0 up, with at most six digits behind the point
    /// Control characters, and bytes that are no UTF-8, become '?'. `json`: for the inside of a JSON string.
    SignalText& addClean(const char* text, bool json = false);
    /// A string of JSON, cleaned too. nullptr and "" become null.
    SignalText& addJson(const char* text);
    void flush();

private:
    void put(char c);

    int m_file;
    std::uint32_t m_held = 0;
    char m_bytes[1024];
};

} // namespace trundle
