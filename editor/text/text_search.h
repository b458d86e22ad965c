#pragma once
// Finding words in the bytes of a text. Places are bytes, whatever they hold.

#include <string>
#include <string_view>
#include <vector>

#include <QRegularExpression>
#include <QString>

#include "base/source_range.h"

namespace trundle {

struct SearchWish {
    QString words;
    bool caseSensitive = false, wholeWords = false, regex = false;
    bool operator==(const SearchWish&) const = default;
};

struct TextMatch {
    TextRange range;
    QStringList groups; ///< [0] all of it; more with a regular expression
};

class TextSearch {
public:
    explicit TextSearch(const SearchWish& wish);

    [[nodiscard]] bool valid() const { return m_pattern.isValid(); }
    [[nodiscard]] QString fault() const { return m_pattern.errorString(); } ///< why a regular expression is none
    /// All of them, in order, none empty, none within another; at most kMostMatches.
    [[nodiscard]] std::vector<TextMatch> in(std::string_view text) const;
    /// What stands for a match afterwards: with a regular expression \1 ... \9 are its groups, \n the text's line end, \t a tab.
    [[nodiscard]] std::string replacement(const TextMatch& match, const QString& with, const std::string& lineEnd = "\n") const;

    static constexpr std::size_t kMostMatches = 100'000;

private:
    QRegularExpression m_pattern;
    bool m_regex = false, m_empty = true;
};

} // namespace trundle
