#pragma once
#include <QObject>
#include <QTimer>

#include "editor/running/active_run.h"

namespace trundle {

class RunMessages;

/// Detects ticks, builds and controllers that take unusually long. The window itself stays responsive.
class ResponseWatch final : public QObject {
    Q_OBJECT
public:
    /// Both must outlive this object.
    ResponseWatch(const ActiveRun& run, RunMessages& messages, QObject* parent = nullptr);

    /// Wall-clock time (s) of the current tick, or of building, if it is unusually long; else 0.
    [[nodiscard]] double seconds() const;
    [[nodiscard]] QString unresponsiveController() const; ///< "robot0's Wanderer"; empty if it is not a controller
    [[nodiscard]] QString text() const;                   ///< the same as a sentence; empty if everything responds

    void setEnabled(bool enabled); ///< a run is active
    void leaveRun();
    /// Nothing is reported any more. True if something was; changed() is left to the caller.
    [[nodiscard]] bool clear();

Q_SIGNALS:
    void changed(); ///< text() changed

private:
    void look();

    const ActiveRun& m_run;
    RunMessages& m_messages;
    QTimer m_timer;
    QString m_text;
    bool m_reported = false;
};

} // namespace trundle
