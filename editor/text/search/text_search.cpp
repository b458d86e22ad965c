#include "editor/text/search/text_search.h"

#include "base/utf8.h"

namespace trundle {
namespace {

/// A text in UTF-16, with the byte offset of each code unit.
struct Utf16Text {
    QString text;
    std::vector<std::uint32_t> places;
};

Utf16Text utf16Of(std::string_view bytes) {
    Utf16Text wide;
    wide.text.reserve(static_cast<qsizetype>(bytes.size()));
    wide.places.reserve(bytes.size() + 1);
    for (std::size_t at = 0; at < bytes.size();) {
        const CodePoint point = codePointAt(bytes, at);
        const char32_t value = point.valid ? point.value : 0xFFFD;
        const auto place = static_cast<std::uint32_t>(at);
        if (QChar::requiresSurrogates(value)) {
            wide.text += QChar(QChar::highSurrogate(value));
            wide.places.push_back(place);
            wide.text += QChar(QChar::lowSurrogate(value));
        } else {
            wide.text += QChar(static_cast<char16_t>(value));
        }
        wide.places.push_back(place);
        at += point.length;
    }
    wide.places.push_back(static_cast<std::uint32_t>(bytes.size()));
    return wide;
}

} // namespace

TextSearch::TextSearch(const SearchOptions& searchOptions)
    : m_regex(searchOptions.regex), m_empty(searchOptions.words.isEmpty()) {
    QString pattern = searchOptions.regex ? searchOptions.words : QRegularExpression::escape(searchOptions.words);
    if (searchOptions.wholeWords) pattern = QStringLiteral("(?<!\\w)(?:%1)(?!\\w)").arg(pattern);
    QRegularExpression::PatternOptions options =
        QRegularExpression::MultilineOption | QRegularExpression::UseUnicodePropertiesOption;
    if (!searchOptions.caseSensitive) options |= QRegularExpression::CaseInsensitiveOption;
    m_pattern = QRegularExpression(searchOptions.regex ? QStringLiteral("(*ANYCRLF)") + pattern : pattern, options);
}

std::vector<TextMatch> TextSearch::in(std::string_view text) const {
    std::vector<TextMatch> found;
    if (!valid() || m_empty) return found;
    const Utf16Text wide = utf16Of(text);
    for (auto matches = m_pattern.globalMatch(wide.text); matches.hasNext() && found.size() < kMaxMatches;) {
        const QRegularExpressionMatch match = matches.next();
        if (match.capturedLength() == 0) continue;
        const TextRange range{wide.places[static_cast<std::size_t>(match.capturedStart())],
                              wide.places[static_cast<std::size_t>(match.capturedEnd())]};
        found.push_back({range, m_regex ? match.capturedTexts() : QStringList()});
    }
    return found;
}

std::string TextSearch::replacement(const TextMatch& match, const QString& with, const std::string& lineEnd) const {
    if (!m_regex) return with.toStdString();
    QString text;
    for (qsizetype i = 0; i < with.size(); ++i) {
        if (with[i] != QLatin1Char('\\') || i + 1 == with.size()) {
            text += with[i];
            continue;
        }
        const QChar next = with[++i];
        if (next.isDigit()) text += match.groups.value(next.digitValue());
        else if (next == QLatin1Char('n')) text += QString::fromStdString(lineEnd);
        else if (next == QLatin1Char('t')) text += QLatin1Char('\t');
        else text += next;
    }
    return text.toStdString();
}

} // namespace trundle
