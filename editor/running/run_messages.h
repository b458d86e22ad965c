#pragma once
#include <vector>

#include <QObject>

#include "base/diagnostic.h"
#include "editor/document/problems_in_code.h"
#include "run/live/live_state.h"

namespace trundle {

/// What the run reports: console lines, diagnostics, and why a command was refused.
class RunMessages final : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    /// Diagnostics of building and running, kept until Reset; their ranges are in the texts of RunResults::built.
    [[nodiscard]] const std::vector<Diagnostic>& problems() const { return m_problems; }
    /// The same, with those that are in the code of a controller there.
    [[nodiscard]] ProblemsInCode problemsInCode(std::shared_ptr<const LoadedProject> built) const;
    void addProblems(std::vector<Diagnostic> problems);
    void clearProblems();
    /// A console line of the window itself at simulated time `time` (s).
    void add(double time, int severity, const QString& text);
    void add(const LiveLines& lines);
    /// Emits refused(); returns false.
    bool refuse(const QString& reason);

Q_SIGNALS:
    void problemsChanged();
    void consoleLines(const std::vector<trundle::LiveLine>& lines, quint64 dropped);
    void refused(const QString& reason);

private:
    std::vector<Diagnostic> m_problems;
};

} // namespace trundle
