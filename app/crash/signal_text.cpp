#include "crash/signal_text.h"

#include <cerrno>
#include <cstring>
#include <string_view>

#include <unistd.h>

#include "base/clean_text.h"
#include "base/utf8.h"

namespace trundle {
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
    const std::string_view all(text);
    for (std::size_t at = 0; at < all.size();) {
        const CodePoint point = codePointAt(all, at);
        if (!point.valid || isControl(point.value)) {
            put('?');
        } else {
            if (json && (point.value == '"' || point.value == '\\')) put('\\');
            add(all.data() + at, point.length);
        }
        at += point.length;
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
