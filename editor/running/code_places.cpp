#include "editor/running/code_places.h"

#include <algorithm>
#include <optional>

#include <QObject>

#include "base/platform/read_file.h"
#include "project/loading/loader.h"
#include "run/live/live_state.h"

namespace trundle {
namespace {

/// The texts of a run and the sources of its controllers.
class TextsWithCode {
public:
    explicit TextsWithCode(const LoadedProject& built) : m_all(std::make_shared<LoadedProject>(built)) {}

    /// The text of a line without the blanks around it; nothing if it cannot be shown.
    std::optional<SourceRange> lineAt(const CodePlace& place) {
        if (place.line < 1 || !place.file.starts_with(m_all->projectFolder + "/")) return std::nullopt;
        const std::optional<FileId> file = idOf(place.file);
        if (!file) return std::nullopt;
        const SourceText& text = *m_all->sources[*file].text;
        if (static_cast<std::uint32_t>(place.line) > text.lineCount()) return std::nullopt; // it has been changed since it was built
        const std::string_view line = text.line(static_cast<std::uint32_t>(place.line));
        const auto start = static_cast<std::size_t>(line.data() - text.bytes().data());
        const std::size_t first = std::min(line.find_first_not_of(" \t"), line.size());
        const std::size_t last = line.find_last_not_of(" \t\r\n");
        const std::size_t end = last == std::string_view::npos ? first : last + 1;
        return SourceRange{*file, {static_cast<std::uint32_t>(start + first), static_cast<std::uint32_t>(start + end)}};
    }
    [[nodiscard]] std::shared_ptr<const LoadedProject> all() const { return m_all; }

private:
    std::optional<FileId> idOf(const std::string& path) {
        const auto known = std::ranges::find(m_all->paths, path);
        if (known != m_all->paths.end()) return static_cast<FileId>(known - m_all->paths.begin());
        Result<std::string> bytes = readRegularFile(path, kMaxTextBytes);
        if (!bytes) return std::nullopt;
        m_all->paths.resize(m_all->sources.size()); // by FileId
        m_all->paths.push_back(path);
        return m_all->sources.add(std::make_shared<const SourceText>(path, std::move(bytes).value()));
    }

    std::shared_ptr<LoadedProject> m_all;
};

} // namespace

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
        const std::optional<SourceRange> line = texts.lineAt(places[i]);
        if (!line) continue;
        problems[i].notes.emplace_back(QObject::tr("the controller's block").toStdString(), problems[i].range);
        problems[i].range = *line;
    }
    return {std::move(problems), texts.all()};
}

} // namespace trundle
