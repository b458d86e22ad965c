#pragma once
// Search in the bytes of a text. Offsets are byte offsets, even in invalid UTF-8.

#include <string>
#include <string_view>
#include <vector>

#include <QRegularExpression>
#include <QString>

#include "base/source_range.h"

namespace trundle {

struct SearchOptions {
    QString words;
    bool caseSensitive = false, wholeWords = false, regex = false;
    bool operator==(const SearchOptions&) const = default;
};

struct TextMatch {
    TextRange range;
    QStringList groups; ///< [0] the whole match; more for a regular expression
};

class TextSearch {
public:
    explicit TextSearch(const SearchOptions& searchOptions);

    [[nodiscard]] bool valid() const { return m_pattern.isValid(); }
    [[nodiscard]] QString fault() const { return m_pattern.errorString(); } ///< error in a regular expression; else empty
    /// All matches in order, neither empty nor overlapping; at most kMaxMatches.
    [[nodiscard]] std::vector<TextMatch> in(std::string_view text) const;
    /// The replacement of a match; with a regular expression \1 ... \9 are its groups, \n the text's line ending, \t a tab.
    [[nodiscard]] std::string replacement(const TextMatch& match, const QString& with, const std::string& lineEnd = "\n") const;

    static constexpr std::size_t kMaxMatches = 100'000;

private:
    QRegularExpression m_pattern;
    bool m_regex = false, m_empty = true;
};

} // namespace trundle
