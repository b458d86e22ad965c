#include "editor/document/problems_in_code.h"

#include <algorithm>
#include <optional>

#include <QCoreApplication>

#include "editor/document/texts_with_code.h"

namespace trundle {
namespace {

std::string noteOf(const Diagnostic& d) {
    const QString note = d.code == Code::PythonModule ? QCoreApplication::translate("ProblemsInCode", "its #loadModule")
                                                      : QCoreApplication::translate("ProblemsInCode", "the controller's block");
    return note.toStdString();
}

} // namespace

ProblemsInCode shownInCode(std::vector<Diagnostic> problems, std::shared_ptr<const LoadedProject> texts) {
    if (!texts || std::ranges::none_of(problems, [](const Diagnostic& d) { return d.place.isKnown(); }))
        return {std::move(problems), std::move(texts)};
    TextsWithCode all(*texts);
    for (Diagnostic& d : problems) {
        const std::optional<SourceRange> line = d.place.isKnown() ? all.lineAt(d.place.file, d.place.line) : std::nullopt;
        if (!line) continue;
        d.notes.emplace_back(noteOf(d), d.range);
        d.range = *line;
    }
    return {std::move(problems), all.all()};
}

} // namespace trundle
