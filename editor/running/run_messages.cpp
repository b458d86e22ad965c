#include "editor/running/run_messages.h"

namespace trundle {

ProblemsInCode RunMessages::problemsInCode(std::shared_ptr<const LoadedProject> built) const {
    return shownInCode(m_problems, std::move(built));
}

void RunMessages::addProblems(std::vector<Diagnostic> problems) {
    if (problems.empty()) return;
    m_problems.insert(m_problems.end(), std::make_move_iterator(problems.begin()), std::make_move_iterator(problems.end()));
    Q_EMIT problemsChanged();
}

void RunMessages::clearProblems() {
    if (m_problems.empty()) return;
    m_problems.clear();
    Q_EMIT problemsChanged();
}

void RunMessages::add(double time, int severity, const QString& text) {
    Q_EMIT consoleLines({{time, "", severity, text.toStdString()}}, 0);
}

void RunMessages::add(const LiveLines& lines) {
    if (!lines.lines.empty() || lines.dropped > 0) Q_EMIT consoleLines(lines.lines, lines.dropped);
}

bool RunMessages::refuse(const QString& reason) {
    Q_EMIT refused(reason);
    return false;
}

} // namespace trundle
