#pragma once
#include <QObject>
#include <QTimer>

namespace trundle {

class RunSession;

/// The run in one line for the status bar: "12 robots • 118 contacts • step 0.21 ms". Updated at most four times a second.
class RunStatus final : public QObject {
    Q_OBJECT
public:
    explicit RunStatus(RunSession& session, QObject* parent = nullptr);
    [[nodiscard]] const QString& text() const { return m_text; } ///< empty at the start
    [[nodiscard]] const QString& tip() const { return m_tip; }   ///< names robots that ended by a fault; or empty

Q_SIGNALS:
    void changed(const QString& text, const QString& tip);

private:
    void refresh();

    RunSession& m_session;
    QTimer m_timer; // active while the run is running
    QString m_text, m_tip;
};

} // namespace trundle
