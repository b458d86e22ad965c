#pragma once
#include <string_view>
#include <vector>

#include <QString>

namespace trundle {

/// One line of a comparison. `Gap` represents omitted unchanged lines.
struct DiffLine {
    enum class Kind { Same, Added, Removed, Gap } kind = Kind::Same;
    QString text;
};

/// The lines that change `before` into `after`, with `context` unchanged lines around each change.
[[nodiscard]] std::vector<DiffLine> diffLines(std::string_view before, std::string_view after, int context = 2);
/// The first lines, as many as fit in a message box.
[[nodiscard]] std::vector<DiffLine> inShort(std::vector<DiffLine> lines);
/// For a QTextBrowser or a label, in the theme's colours.
[[nodiscard]] QString diffAsHtml(const std::vector<DiffLine>& lines);

} // namespace trundle
