#include "editor/running/run_edits.h"

#include <algorithm>

#include "editor/widgets/name_list.h"
#include "model/dotted_path.h"

namespace trundle {

void RunEdits::begin(std::shared_ptr<const LoadedProject> built) {
    m_built = std::move(built);
    m_sameRobots.begin(m_built);
    m_comparison.begin(m_built);
}

LiveEdits RunEdits::follow(const ChangeSet& changes, const std::shared_ptr<const LoadedProject>& source,
                           const ExperimentSpec& running) {
    m_sameRobots.follow(changes);
    // A preview of configs is built from a text of its own.
    return m_comparison.follow(source == changes.after() ? changes : ChangeSet::ofEverything(m_built, source), running);
}

void RunEdits::setWaiting(std::vector<std::string> paths) {
    if (paths == m_waiting) return;
    m_waiting = std::move(paths);
    Q_EMIT changed();
}

bool RunEdits::clear() {
    const bool waited = needsReset();
    m_waiting.clear();
    return waited;
}

QString RunEdits::waitingText() const {
    constexpr int kMaxNamed = 3;
    QStringList names;
    for (const std::string& path : m_waiting) names += QString::fromStdString(path);
    return listed(names, kMaxNamed);
}

bool RunEdits::waitsForReset(const std::string& path) const {
    return std::ranges::any_of(m_waiting, [&](const std::string& waiting) { return startsWithPath(path, waiting); });
}

} // namespace trundle
