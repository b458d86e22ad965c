#include "lang/diagnostic_text.h"

#include <algorithm>

#include "base/clean_text.h"
#include "base/utf8.h"

namespace trundle {
namespace {

constexpr std::size_t kWidest = 160;     ///< longest excerpt of a line, in code points
constexpr std::size_t kBeforeCaret = 60; ///< code points kept before the caret when the line is cut
constexpr int kLongestChain = 40;
constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

/// A source line as displayed, code point by code point, with the byte offset of each.
struct ShownLine {
    struct Cell {
        std::string text;
        std::size_t byte;
    };
    std::vector<Cell> cells;
};

ShownLine show(std::string_view line, std::size_t from, std::size_t to) {
    ShownLine shown;
    for (std::size_t at = from; at < std::min(to, line.size());) {
        const CodePoint point = codePointAt(line, at);
        const bool control = point.value != '\t' && isControl(point.value);
        if (point.valid && point.value == 0xFEFF) { // has no column
            at += point.length;
            continue;
        }
        shown.cells.push_back(
            {point.valid && !control ? std::string(line.substr(at, point.length)) : std::string(kReplacement), at});
        at += point.length;
    }
    return shown;
}

/// The start of the code point that contains `at`, moved back by `count` code points.
std::size_t back(std::string_view line, std::size_t at, std::size_t count) {
    while (at > 0 && count-- > 0) {
        --at;
        for (int i = 0; i < 3 && at > 0 && (static_cast<unsigned char>(line[at]) & 0xC0) == 0x80; ++i) --at;
    }
    return at;
}

std::string severityName(Severity severity) {
    return severity == Severity::Error ? "error" : severity == Severity::Warning ? "warning" : "hint";
}

std::string place(const SourceText& text, std::uint32_t offset) {
    const LineColumn at = text.position(offset);
    return cleanLine(text.path()) + ":" + std::to_string(at.line) + ":" + std::to_string(at.column);
}

std::string advice(const Diagnostic& d) {
    if (!d.fixes.empty()) return "fix: " + cleanLine(d.fixes[0].title);
    if (d.suggestions.empty()) return {};
    return "did you mean " + cleanLine(d.suggestions[0]) + "?";
}

/// The source line and the line of carets below it.
std::string excerpt(const Diagnostic& d, const SourceText& text) {
    const std::uint32_t lineNumber = text.position(d.range.range.begin).line;
    const std::string_view line = text.line(lineNumber);
    const auto lineBegin = static_cast<std::size_t>(line.data() - text.bytes().data());
    const std::size_t begin =
        std::min<std::size_t>(d.range.range.begin - std::min<std::size_t>(lineBegin, d.range.range.begin), line.size());
    const std::size_t end = std::min(std::max<std::size_t>(d.range.range.end, lineBegin + begin) - lineBegin, line.size());

    // A long line is cut to a window around the caret.
    std::size_t from = 0;
    bool cutBefore = false, cutAfter = false;
    if (line.size() > kWidest) {
        from = back(line, begin, kBeforeCaret);
        cutBefore = from > 0;
    }
    ShownLine shown = show(line, from, from + 4 * kWidest + 4);
    if (shown.cells.size() > kWidest) {
        shown.cells.resize(kWidest);
        cutAfter = true;
    }

    std::string source = cutBefore ? "..." : "";
    std::string marks = cutBefore ? "   " : "";
    bool caret = false;
    for (const ShownLine::Cell& cell : shown.cells) {
        source += cell.text;
        if (cell.byte < begin) marks += cell.text == "\t" ? "\t" : " ";
        else if (!caret) marks += '^', caret = true;
        else if (cell.byte < end) marks += '~';
    }
    if (!caret) marks += '^';
    if (cutAfter) source += "...";
    while (!source.empty() && (source.back() == ' ' || source.back() == '\t')) source.pop_back();

    std::string number = std::to_string(lineNumber);
    if (number.size() < 5) number.insert(0, 5 - number.size(), ' ');
    std::string out =
        number + " |" + (source.empty() ? "" : " " + source) + "\n" + std::string(number.size(), ' ') + " | " + marks;
    if (const std::string words = advice(d); !words.empty()) out += "  " + words;
    return out + "\n";
}

} // namespace

std::string render(const Diagnostic& d, const SourceTable& sources) {
    const std::string head = severityName(d.severity) + " " + codeName(d.code) + ": " + cleanLine(d.message) + "\n";
    const bool placed = d.range.file < sources.size() && sources[d.range.file].text;
    std::string out;
    if (placed) {
        const SourceText& text = *sources[d.range.file].text;
        out = place(text, d.range.range.begin) + ": " + head + excerpt(d, text);
    } else {
        out = head;
        if (const std::string words = advice(d); !words.empty()) out += "  " + words + "\n";
    }
    for (const auto& [words, range] : d.notes) {
        if (range.file < sources.size() && sources[range.file].text)
            out += place(*sources[range.file].text, range.range.begin) + ": ";
        out += "note: " + cleanLine(words) + "\n";
    }
    if (!placed) return out;
    SourceRange from = sources[d.range.file].importedFrom;
    for (int i = 0; i < kLongestChain && from.file < sources.size() && sources[from.file].text; ++i) {
        const SourceText& text = *sources[from.file].text;
        out += "imported from " + cleanLine(text.path()) + ":" + std::to_string(text.position(from.range.begin).line) + "\n";
        from = sources[from.file].importedFrom;
    }
    return out;
}

} // namespace trundle
