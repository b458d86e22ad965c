#pragma once
#include <QObject>
#include <QTimer>

#include "editor/shell/main_window.h"
#include "trundle/options.h"

namespace trundle {

/// Executes the options in order: open, select, view, run, screenshot, quit. Each step waits for the condition it needs instead
/// of a fixed time.
class ScreenshotRunner final : public QObject {
    Q_OBJECT
public:
    ScreenshotRunner(MainWindow& window, const WindowOptions& options);

private:
    void next();
    [[nodiscard]] bool select();
    void refuse(const QString& reason);
    void reportNoRun(const QString& reason);
    void runEnded(const Diagnostic& reason);
    void reportEnd(const QString& reason, int code);
    void take();
    [[nodiscard]] bool runDone() const;
    [[nodiscard]] bool isStuck() const;

    MainWindow& m_window;
    WindowOptions m_options;
    enum class Step { Open, Opening, Run, Running, Draw, Done } m_step = Step::Open;
    int m_code = 0; // exit code
    QTimer m_look;  // polls while a step is in progress
};

} // namespace trundle
