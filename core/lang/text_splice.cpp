#include "lang/text_splice.h"

#include <algorithm>

namespace trundle {

namespace {

std::string replaced(std::string_view text, std::uint64_t at, std::size_t length, const std::string& by) {
    const std::size_t begin = std::min<std::size_t>(at, text.size()), end = std::min(begin + length, text.size());
    std::string out;
    out.reserve(text.size() - (end - begin) + by.size());
    return out.append(text.substr(0, begin)).append(by).append(text.substr(end));
}

} // namespace

TextSplice spliceBetween(std::string_view before, std::string_view after) {
    const std::size_t most = std::min(before.size(), after.size());
    const auto head = static_cast<std::size_t>(
        std::mismatch(before.begin(), before.begin() + static_cast<std::ptrdiff_t>(most), after.begin()).first - before.begin());
    const std::size_t rest = most - head;
    const auto tail = static_cast<std::size_t>(
        std::mismatch(before.rbegin(), before.rbegin() + static_cast<std::ptrdiff_t>(rest), after.rbegin()).first -
        before.rbegin());
    return {head, std::string(before.substr(head, before.size() - head - tail)),
            std::string(after.substr(head, after.size() - head - tail))};
}

std::string spliced(std::string_view before, const TextSplice& splice) {
    return replaced(before, splice.at, splice.removed.size(), splice.inserted);
}

std::string unspliced(std::string_view after, const TextSplice& splice) {
    return replaced(after, splice.at, splice.inserted.size(), splice.removed);
}

TextSplice joined(const TextSplice& first, const TextSplice& second, std::string_view middle) {
    const std::uint64_t begin = std::min<std::uint64_t>({first.at, second.at, middle.size()}),
                        end = std::max(first.at + first.inserted.size(), second.at + second.removed.size());
    const std::string_view changed = middle.substr(begin, std::max(begin, end) - begin);
    const std::string before = replaced(changed, first.at - begin, first.inserted.size(), first.removed),
                      after = replaced(changed, second.at - begin, second.removed.size(), second.inserted);
    TextSplice whole = spliceBetween(before, after);
    whole.at += begin;
    return whole;
}

} // namespace trundle
