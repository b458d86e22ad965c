#include "base/diagnostic.h"

#include <algorithm>
#include <functional>

namespace trundle {

namespace {

constexpr std::size_t kLongestShownWord = 200, kLongestShownMessage = 2000; // bytes
constexpr std::size_t kMaxFingerprints = 100'000;
constexpr std::string_view kEllipsis = "\xE2\x80\xA6";

bool continues(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; }

/// Shortens a text to about `most` bytes: the first two thirds from its start, the rest from its end.
std::string cutInside(std::string_view text, std::size_t most) {
    std::size_t begin = most * 2 / 3, end = text.size() - (most - begin);
    while (begin > 0 && continues(text[begin])) --begin;
    while (end < text.size() && continues(text[end])) ++end;
    std::string cut(text.substr(0, begin));
    cut += kEllipsis;
    return cut += text.substr(end);
}

std::string countedOf(std::uint64_t count, const char* what) {
    return std::to_string(count) + " more " + what + (count == 1 ? "" : "s");
}

} // namespace

std::string shortenedMessage(std::string text) {
    if (text.size() <= kLongestShownWord) return text;
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        const std::string_view word = std::string_view(text).substr(at, end - at);
        out += word.size() > kLongestShownWord ? cutInside(word, kLongestShownWord) : std::string(word);
        if (end < text.size()) out += ' ';
        at = end + 1;
    }
    return out.size() > kLongestShownMessage ? cutInside(out, kLongestShownMessage) : out;
}

/// A config shared by many robots produces the same message once per robot.
bool Diagnostics::isRepeated(const Diagnostic& d) {
    std::uint64_t print = std::hash<std::string>()(d.message);
    for (const std::uint64_t part : {std::uint64_t(d.severity), std::uint64_t(d.code), std::uint64_t(d.range.file),
                                     std::uint64_t(d.range.range.begin), std::uint64_t(d.range.range.end)})
        print = (print ^ part) * 0x9E3779B97F4A7C15ull + (print >> 29);
    if (m_fingerprints.size() >= kMaxFingerprints) return m_fingerprints.contains(print);
    return !m_fingerprints.insert(print).second;
}

Diagnostic& Diagnostics::take(Diagnostic d) {
    const bool error = d.severity == Severity::Error;
    m_errors += error;
    if (isRepeated(d)) return m_omitted = std::move(d);
    Count& file = m_counts[d.range.file];
    const bool room = error ? file.errors < kMaxOfOneFile && m_total.errors < kMaxOfAll
                            : file.others < kMaxOfOneFile && m_total.others < kMaxOfAll;
    if (room) {
        ++(error ? file.errors : file.others);
        ++(error ? m_total.errors : m_total.others);
        return m_all.emplace_back(std::move(d));
    }
    if (file.omittedErrors + file.omittedOthers == 0) file.firstOmitted = d.range;
    ++(error ? file.omittedErrors : file.omittedOthers);
    return m_omitted = std::move(d);
}

Diagnostic& Diagnostics::add(Severity severity, Code code, SourceRange range, std::string message) {
    Diagnostic d;
    d.severity = severity;
    d.code = code;
    d.range = range;
    d.message = shortenedMessage(std::move(message));
    return take(std::move(d));
}

void Diagnostics::append(std::vector<Diagnostic> more) {
    for (Diagnostic& d : more) {
        d.message = shortenedMessage(std::move(d.message));
        for (Fix& fix : d.fixes) fix.title = shortenedMessage(std::move(fix.title));
        (void)take(std::move(d));
    }
}

void Diagnostics::addOmitted(const Diagnostics& other) {
    for (const auto& [file, count] : other.m_counts) {
        if (count.omittedErrors + count.omittedOthers == 0) continue;
        Count& mine = m_counts[file];
        if (mine.omittedErrors + mine.omittedOthers == 0) mine.firstOmitted = count.firstOmitted;
        mine.omittedErrors += count.omittedErrors;
        mine.omittedOthers += count.omittedOthers;
        m_errors += count.omittedErrors;
    }
}

void Diagnostics::addLast(Diagnostic d) {
    m_errors += d.severity == Severity::Error;
    m_all.push_back(std::move(d));
}

void Diagnostics::summarize() {
    for (auto& [file, count] : m_counts) {
        const std::uint64_t omitted = count.omittedErrors + count.omittedOthers;
        if (omitted == 0) continue;
        Diagnostic d;
        d.severity = count.omittedErrors > 0 ? Severity::Error : Severity::Warning;
        d.code = Code::TooManyMistakes;
        d.range = count.firstOmitted;
        d.message = "and " + (count.omittedErrors > 0 ? countedOf(count.omittedErrors, "error") : std::string()) +
                    (count.omittedErrors > 0 && count.omittedOthers > 0 ? " and " : "") +
                    (count.omittedOthers > 0 ? countedOf(count.omittedOthers, "warning") : std::string()) +
                    (file == kNoFile ? "" : " in this file") + "; fix the ones above first";
        d.more = omitted;
        m_all.push_back(std::move(d));
        count.omittedErrors = count.omittedOthers = 0;
    }
}

} // namespace trundle
