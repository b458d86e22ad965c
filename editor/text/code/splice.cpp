#include "editor/text/code/splice.h"

#include <algorithm>

namespace trundle {
namespace {

bool isContinuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

/// Whether a splice may begin or end there: not inside a character or a CR LF.
bool mayCut(std::string_view text, std::size_t at) {
    if (at == 0 || at >= text.size()) return true;
    return !isContinuation(text[at]) && !(text[at - 1] == '\r' && text[at] == '\n');
}

/// A single splice from the first to the last difference.
Splice wholeSplice(std::string_view from, std::string_view to) {
    const std::size_t shorter = std::min(from.size(), to.size());
    std::size_t head = static_cast<std::size_t>(
        std::mismatch(from.begin(), from.begin() + static_cast<std::ptrdiff_t>(shorter), to.begin()).first - from.begin());
    while (head > 0 && !(mayCut(from, head) && mayCut(to, head))) --head;
    std::size_t tail = 0;
    while (tail < shorter - head && from[from.size() - 1 - tail] == to[to.size() - 1 - tail]) ++tail;
    while (tail > 0 && !(mayCut(from, from.size() - tail) && mayCut(to, to.size() - tail))) --tail;
    return {head, from.size() - head - tail, std::string(to.substr(head, to.size() - head - tail))};
}

/// Lines including their endings.
std::vector<std::string_view> linesOf(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        const std::size_t size = end == std::string_view::npos ? text.size() : end + 1;
        lines.push_back(text.substr(0, size));
        text.remove_prefix(size);
    }
    return lines;
}

} // namespace

std::vector<Splice> splicesBetween(std::string_view from, std::string_view to) {
    if (from == to) return {};
    const Splice whole = wholeSplice(from, to);
    const auto before = linesOf(from.substr(whole.at, whole.removed)), after = linesOf(whole.text);
    if (before.size() != after.size() || before.size() < 2) return {whole};
    std::vector<Splice> splices;
    std::size_t at = whole.at;
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (before[i] != after[i]) {
            Splice part = wholeSplice(before[i], after[i]);
            part.at += at;
            splices.push_back(std::move(part));
        }
        at += before[i].size();
    }
    return splices;
}

std::string spliced(std::string_view text, const std::vector<Splice>& splices) {
    std::string result;
    std::size_t at = 0;
    for (const Splice& s : splices) {
        result += text.substr(at, s.at - at);
        result += s.text;
        at = s.at + s.removed;
    }
    result += text.substr(at);
    return result;
}

std::size_t movedOffset(std::size_t offset, const std::vector<Splice>& splices) {
    std::ptrdiff_t shift = 0;
    for (const Splice& s : splices) {
        if (s.at > offset) break;
        if (offset < s.at + s.removed) return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(s.at) + shift) + s.text.size();
        shift += static_cast<std::ptrdiff_t>(s.text.size()) - static_cast<std::ptrdiff_t>(s.removed);
    }
    return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(offset) + shift);
}

std::string merged(std::string_view base, std::string_view ours, std::string_view theirs) {
    if (ours == base || ours == theirs) return std::string(theirs);
    if (theirs == base) return std::string(ours);
    const Splice own = wholeSplice(base, ours);
    std::vector<Splice> both = splicesBetween(base, theirs);
    const auto apart = [&](const Splice& s) { return s.at + s.removed <= own.at || own.at + own.removed <= s.at; };
    if (std::all_of(both.begin(), both.end(), apart)) {
        const auto place = std::find_if(both.begin(), both.end(), [&](const Splice& s) { return s.at >= own.at + own.removed; });
        both.insert(place, own);
        return spliced(base, both);
    }
    std::string result(theirs);
    result.insert(std::min(movedOffset(own.at + own.removed, both), result.size()), own.text);
    return result;
}

} // namespace trundle
