#include "crash/signal_text.h"

#include <cerrno>
#include <cstring>

#include <unistd.h>

namespace trundle {
namespace {

/// Bytes of the valid UTF-8 sequence at `s`; 0 if there is none.
unsigned sequenceAt(const unsigned char* s) {
    const auto follows = [](unsigned char c) { return (c & 0xc0) == 0x80; };
    if (s[0] < 0x80) return 1;
    if (s[0] >= 0xc2 && s[0] < 0xe0) return follows(s[1]) ? 2 : 0;
    if (s[0] >= 0xe0 && s[0] < 0xf0) {
        const bool overlong = s[0] == 0xe0 && s[1] < 0xa0, surrogate = s[0] == 0xed && s[1] >= 0xa0;
        return follows(s[1]) && !overlong && !surrogate && follows(s[2]) ? 3 : 0;
    }
    if (s[0] >= 0xf0 && s[0] < 0xf5) {
        const bool overlong = s[0] == 0xf0 && s[1] < 0x90, beyond = s[0] == 0xf4 && s[1] >= 0x90;
        return follows(s[1]) && !overlong && !beyond && follows(s[2]) && follows(s[3]) ? 4 : 0;
    }
    return 0;
}

} // namespace

void SignalText::put(char c) {
    if (m_held == sizeof m_bytes) flush();
    m_bytes[m_held++] = c;
}

void SignalText::flush() {
    const char* bytes = m_bytes;
    while (m_held > 0 && m_file >= 0) {
        const ssize_t done = ::write(m_file, bytes, m_held);
        if (done < 0 && errno == EINTR) continue;
        if (done <= 0) break;
        bytes += done;
        m_held -= static_cast<std::uint32_t>(done);
    }
    m_held = 0;
}

SignalText& SignalText::add(const char* text) { return add(text, std::strlen(text)); }

SignalText& SignalText::add(const char* bytes, std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i) put(bytes[i]);
    return *this;
}

SignalText& SignalText::add(std::uint64_t number) {
    char digits[20];
    int count = 0;
    do digits[count++] = static_cast<char>('0' + number % 10);
    while (number /= 10);
    while (count > 0) put(digits[--count]);
    return *this;
}

SignalText& SignalText::add(double number) {
    constexpr std::uint64_t kParts = 1'000'000;
    if (!(number > 0)) number = 0;
    if (number > 1e12) number = 1e12;
    const auto parts = static_cast<std::uint64_t>(number * kParts + 0.5);
    add(parts / kParts);
    std::uint64_t rest = parts % kParts;
    if (rest == 0) return *this;
    put('.');
    for (std::uint64_t place = kParts / 10; rest > 0; place /= 10) {
        put(static_cast<char>('0' + rest / place));
        rest %= place;
    }
    return *this;
}

SignalText& SignalText::addClean(const char* text, bool json) {
    for (const auto* s = reinterpret_cast<const unsigned char*>(text); *s;) {
        const unsigned length = sequenceAt(s);
        const bool control = *s < 0x20 || *s == 0x7f || (*s == 0xc2 && s[1] < 0xa0);
        if (length == 0 || control) put('?');
        else {
            if (json && (*s == '"' || *s == '\\')) put('\\');
            add(reinterpret_cast<const char*>(s), length);
        }
        s += length ? length : 1;
    }
    return *this;
}

SignalText& SignalText::addJson(const char* text) {
    if (!text || !*text) return add("null");
    put('"');
    addClean(text, true);
    put('"');
    return *this;
}

} // namespace trundle
