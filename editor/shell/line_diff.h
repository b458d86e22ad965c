#pragma once
#include <string_view>
#include <vector>

#include <QString>

namespace trundle {

/// One line of a comparison. Unchanged lines far from any change are left out; `Gap` stands for them.
struct DiffLine {
    enum class Kind { Same, Added, Removed, Gap } kind = Kind::Same;
    QString text;
};

/// What turns `before` into `after`, with `context` unchanged lines around each change.
[[nodiscard]] std::vector<DiffLine> diffLines(std::string_view before, std::string_view after, int context = 2);
/// The first lines of them, cut to what has room in a question.
[[nodiscard]] std::vector<DiffLine> inShort(std::vector<DiffLine> lines);
/// For a QTextBrowser or a label, in the colours of the theme.
[[nodiscard]] QString diffAsHtml(const std::vector<DiffLine>& lines);

} // namespace trundle
