#pragma once
#include <QObject>
#include <QTimer>

#include "editor/shell/main_window.h"
#include "trundle/options.h"

namespace trundle {

/// Carries out the options in order: open, select, view, run, picture, quit. Each waits for what it needs, none for a time.
class PictureTaker final : public QObject {
    Q_OBJECT
public:
    PictureTaker(MainWindow& window, const WindowOptions& options);

private:
    void next();
    [[nodiscard]] bool select();
    void refuse(const QString& reason);
    void noRun(const QString& reason);
    void runEnded(const Diagnostic& reason);
    void say(const QString& reason, int code);
    void take();
    [[nodiscard]] bool runDone() const;
    [[nodiscard]] bool isStuck() const;

    MainWindow& m_window;
    WindowOptions m_options;
    enum class Stage { Open, Opening, Run, Running, Draw, Done } m_stage = Stage::Open;
    int m_code = 0; // to leave with
    QTimer m_look;  // looks again while something is under way
};

} // namespace trundle
