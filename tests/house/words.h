#pragma once
#include <QList>
#include <QRegularExpression>
#include <QString>

#include "house/source_files.h"

namespace trundle {

/// Where a word is forbidden.
enum class WordScope {
    Everywhere, ///< names, texts and comments
    Code,       ///< names and texts
    Texts,      ///< texts that a user reads: string literals of the product, and the guide
};

/// A forbidden word and its replacement.
struct WordRule {
    QRegularExpression pattern;
    QString instead;
    WordScope scope;
};

struct WordHit {
    QString path;
    int line = 0;
    QString word, instead;
};

/// The forbidden words of core/README.md#words.
[[nodiscard]] const QList<WordRule>& wordRules();
/// Matches whole words of prose and of camelCase and snake_case names, with any first letter: "held up" finds "Held up", heldUp and
/// m_held_up, but not "withheld up". Each word begins with a letter; what follows may be a regular expression.
[[nodiscard]] QRegularExpression wordPattern(const QString& words);
/// Every use of a forbidden word in a C++ file or a page of the guide.
[[nodiscard]] QList<WordHit> forbiddenWords(const SourceFile& file);

} // namespace trundle
