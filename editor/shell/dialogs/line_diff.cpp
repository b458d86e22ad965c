#include "editor/shell/dialogs/line_diff.h"

#include <algorithm>

#include "editor/widgets/theme.h"
#include "lang/line_merge.h"

namespace trundle {
namespace {

std::vector<QString> linesOf(std::string_view text) {
    std::vector<QString> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size() - 1);
        std::string_view line = text.substr(0, end + 1);
        text.remove_prefix(end + 1);
        while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.remove_suffix(1);
        lines.push_back(QString::fromUtf8(line.data(), qsizetype(line.size())));
    }
    return lines;
}

} // namespace

std::vector<DiffLine> diffLines(std::string_view before, std::string_view after, int context) {
    using Kind = DiffLine::Kind;
    const std::vector<QString> a = linesOf(before), b = linesOf(after);
    std::vector<DiffLine> lines;
    int done = 0; // lines of `before` processed so far
    const auto same = [&](int to) {
        for (; done < to; ++done) lines.push_back({Kind::Same, a[std::size_t(done)]});
    };
    const auto skipTo = [&](int line) {
        if (line <= done) return;
        lines.push_back({Kind::Gap, {}});
        done = line;
    };
    for (const LineHunk& hunk : lineHunks(before, after)) {
        if (!lines.empty()) same(std::min(hunk.begin, done + context));
        skipTo(hunk.begin - context);
        same(hunk.begin);
        for (; done < hunk.end; ++done) lines.push_back({Kind::Removed, a[std::size_t(done)]});
        for (int i = hunk.from; i < hunk.to; ++i) lines.push_back({Kind::Added, b[std::size_t(i)]});
    }
    if (!lines.empty()) same(std::min(int(a.size()), done + context));
    skipTo(int(a.size()));
    return lines;
}

std::vector<DiffLine> inShort(std::vector<DiffLine> lines) {
    constexpr std::size_t kMost = 12;
    constexpr qsizetype kWide = 80;
    if (lines.size() > kMost) {
        lines.resize(kMost);
        lines.push_back({DiffLine::Kind::Gap, {}});
    }
    for (DiffLine& line : lines)
        if (line.text.size() > kWide) line.text = line.text.left(kWide) + QStringLiteral("…");
    return lines;
}

QString diffAsHtml(const std::vector<DiffLine>& lines) {
    using Kind = DiffLine::Kind;
    QString html = QStringLiteral("<pre style=\"margin:0; font-family:'%1'\">").arg(monospaceFont().family());
    for (const DiffLine& line : lines) {
        const Ink colour = line.kind == Kind::Added     ? Ink::Good
                           : line.kind == Kind::Removed ? Ink::Error
                           : line.kind == Kind::Gap     ? Ink::Faint
                                                        : Ink::Text;
        const QString mark = line.kind == Kind::Added     ? QStringLiteral("+ ")
                             : line.kind == Kind::Removed ? QStringLiteral("- ")
                             : line.kind == Kind::Gap     ? QStringLiteral("…")
                                                          : QStringLiteral("  ");
        html += QStringLiteral("<span style=\"color:%1\">%2</span>\n").arg(ink(colour).name(), mark + line.text.toHtmlEscaped());
    }
    return html + QStringLiteral("</pre>");
}

} // namespace trundle
