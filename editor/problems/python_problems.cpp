#include "editor/problems/python_problems.h"

#include <filesystem>
#include <optional>
#include <utility>

#include <QCoreApplication>
#include <QRegularExpression>

#include "editor/document/texts_with_code.h"
#include "editor/widgets/strings.h"

namespace trundle {
namespace {

/// The file that a message begins with, or one beside it, and the line that it ends with: "/a/zig.py cannot be loaded: ..., in Zig at zig.py:22".
std::optional<std::pair<std::string, int>> placeIn(const std::string& message) {
    static const QRegularExpression words(QStringLiteral(R"(^(.*?\.py) .*[ (]at ([^/\s]+\.py):(\d+)\W*$)"));
    const QRegularExpressionMatch found = words.match(toQString(message));
    if (!found.hasMatch()) return std::nullopt;
    const std::filesystem::path module = found.captured(1).toStdString();
    return std::pair((module.parent_path() / found.captured(2).toStdString()).string(), found.captured(3).toInt());
}

} // namespace

PythonProblems pythonProblemsOf(const std::shared_ptr<const LoadedProject>& loaded) {
    PythonProblems problems{{}, loaded};
    if (!loaded) return problems;
    std::optional<TextsWithCode> texts;
    for (const Diagnostic& d : loaded->diagnostics.all()) {
        if (d.code != Code::PythonModule) continue;
        Diagnostic& shown = problems.found.emplace_back(d);
        const auto place = placeIn(d.message);
        if (!place) continue;
        if (!texts) texts.emplace(*loaded);
        const auto line = texts->lineAt(place->first, place->second);
        if (!line) continue;
        shown.notes.emplace_back(QCoreApplication::translate("ProblemsPanel", "its #loadModule").toStdString(), d.range);
        shown.range = *line;
    }
    if (texts) problems.texts = texts->all();
    return problems;
}

} // namespace trundle
