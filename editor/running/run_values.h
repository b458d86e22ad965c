#pragma once
#include <memory>
#include <string>
#include <vector>

#include <QObject>
#include <QTimer>

#include "editor/running/active_run.h"
#include "run/live/live_values.h"

namespace trundle {

class RunEdits;

/// Live values of the objects of a run, for property rows, tooltips and read-outs.
class RunValues final : public QObject {
    Q_OBJECT
public:
    /// Both must outlive this object.
    RunValues(const RunResults& results, const RunEdits& edits, QObject* parent = nullptr);

    /// Live values of "robot0.leftMotor"; "": of the run itself. Empty for an object that is not in this run. Valid until the
    /// next call.
    [[nodiscard]] const std::vector<LiveValue>& of(const std::string& path) const;
    /// The same as rich text for a tooltip; empty if there are none.
    [[nodiscard]] QString tip(const std::string& path) const;

    void begin(); ///< the world is built
    void clear() { m_objects.reset(); }
    void stateChanged(); ///< changed() now
    void advanced();     ///< changed() now or soon

Q_SIGNALS:
    void changed(); ///< of() may differ: at most 10 times a second, and once more when the run stops

private:
    const RunResults& m_results;
    const RunEdits& m_edits;
    std::unique_ptr<LiveObjects> m_objects;
    QTimer m_pause; // minimum interval of changed()
    bool m_waits = false;
};

} // namespace trundle
