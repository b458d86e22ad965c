#include "editor/running/code_places.h"

#include <algorithm>
#include <optional>

#include <QObject>

#include "editor/document/texts_with_code.h"
#include "run/live/live_state.h"

namespace trundle {

std::vector<CodePlace> codePlacesOf(const std::vector<Diagnostic>& problems, const LiveSnapshot* snapshot) {
    std::vector<CodePlace> places(problems.size());
    for (std::size_t i = 0; snapshot && i < problems.size(); ++i)
        if (const StoppedController* stopped = stoppedBy(problems[i], snapshot->stopped))
            places[i] = {stopped->fault.file, stopped->fault.line};
    return places;
}

ProblemsInCode shownInCode(std::vector<Diagnostic> problems, const std::vector<CodePlace>& places,
                           std::shared_ptr<const LoadedProject> built) {
    const auto isKnown = [](const CodePlace& place) { return !place.file.empty(); };
    if (!built || std::ranges::none_of(places, isKnown)) return {std::move(problems), std::move(built)};
    TextsWithCode texts(*built);
    for (std::size_t i = 0; i < problems.size() && i < places.size(); ++i) {
        if (!isKnown(places[i])) continue;
        const std::optional<SourceRange> line = texts.lineAt(places[i].file, places[i].line);
        if (!line) continue;
        problems[i].notes.emplace_back(QObject::tr("the controller's block").toStdString(), problems[i].range);
        problems[i].range = *line;
    }
    return {std::move(problems), texts.all()};
}

} // namespace trundle
