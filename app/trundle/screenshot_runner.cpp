#include "trundle/screenshot_runner.h"

#include <QApplication>
#include <QFileInfo>

#include "editor/shell/work_area.h"
#include "editor/widgets/actions.h"
#include "project/objects/object_location.h"
#include "trundle/problem.h"

namespace trundle {

static constexpr double kTimeoutS = 5;             // s, for a controller that does not return
static constexpr int kNoRun = 1, kRunCutShort = 3; // documented in --help

ScreenshotRunner::ScreenshotRunner(MainWindow& window, const WindowOptions& options) : m_window(window), m_options(options) {
    m_look.setInterval(10);
    if (m_options.quit) { // no user is present to read a message in the window
        disconnect(&m_window.document().opening(), &ProjectOpening::failed, nullptr, nullptr);
        connect(&m_window.document().opening(), &ProjectOpening::failed, this,
                [this](const QString& path, const QString& reason) {
                    refuse(reason.contains(path) ? reason : QStringLiteral("%1: %2").arg(path, reason));
                });
    }
    connect(&m_window.session().messages(), &RunMessages::refused, this, &ScreenshotRunner::reportNoRun);
    connect(&m_window.session(), &RunSession::ended, this, &ScreenshotRunner::runEnded);
    connect(&m_look, &QTimer::timeout, this, &ScreenshotRunner::next);
    m_look.start();
}

void ScreenshotRunner::next() {
    switch (m_step) {
    case Step::Open:
        if (m_options.layout) m_window.setLayout(*m_options.layout);
        if (!m_options.look.isEmpty())
            m_window.actions()
                .at(m_options.look == QStringLiteral("rich")   ? "view.lookRich"
                    : m_options.look == QStringLiteral("fast") ? "view.lookFast"
                                                               : "view.lookAutomatic")
                .trigger();
        if (!m_options.open.isEmpty()) m_window.open(QFileInfo(m_options.open).absoluteFilePath());
        m_step = Step::Opening;
        break;
    case Step::Opening:
        if (m_window.document().opening().isOpening()) return;
        if (!select()) return;
        if (!m_window.work().useView(m_options.view) && m_options.quit)
            return refuse(
                QStringLiteral("there is no view %1; --view takes perspective, top, front, side, follow, chase, text, or "
                               "a View of FILE")
                    .arg(m_options.view));
        m_step = m_options.runFor && m_window.document().isOpen() ? Step::Run : Step::Draw;
        break;
    case Step::Run:
        m_window.session().runFor(*m_options.runFor);
        m_step = Step::Running;
        break;
    case Step::Running:
        if (isStuck()) reportEnd(m_window.session().responses().text(), kRunCutShort);
        if (runDone() || m_code) m_step = Step::Draw;
        break;
    case Step::Draw:
        if (!m_window.isSettled()) return;
        take();
        m_step = Step::Done;
        break;
    case Step::Done:
        m_look.stop();
        if (m_options.quit) QApplication::exit(m_code);
        break;
    }
}

void ScreenshotRunner::reportEnd(const QString& reason, int code) {
    printProblem(reason);
    m_code = code;
}

/// Ends without a screenshot. The window closes as usual, so that its resources are released.
void ScreenshotRunner::refuse(const QString& reason) {
    reportEnd(reason, 2);
    m_step = Step::Done;
}

/// The screenshot is still taken, of the start state.
void ScreenshotRunner::reportNoRun(const QString& reason) {
    if (m_step == Step::Run) reportEnd(QStringLiteral("%1 did not run: %2").arg(m_options.open, reason), kNoRun);
}

void ScreenshotRunner::runEnded(const Diagnostic& reason) {
    if (m_step != Step::Running) return;
    const QString why = QString::fromStdString(codeName(reason.code) + ": " + reason.message);
    const RunSession& session = m_window.session();
    if (!session.results().layout) return reportEnd(QStringLiteral("%1 did not run: %2").arg(m_options.open, why), kNoRun);
    reportEnd(QStringLiteral("the run of %1 ended at t = %2 s: %3")
                  .arg(m_options.open, QString::number(session.results().end->time), why),
              kRunCutShort);
}

bool ScreenshotRunner::select() {
    std::vector<std::string> paths;
    const std::shared_ptr<const LoadedProject> loaded = m_window.document().loaded();
    for (const QString& path : m_options.select) {
        paths.push_back(path.toStdString());
        if (m_options.quit && (!loaded || !placeOf(*loaded, paths.back()))) {
            refuse(QStringLiteral("there is no %1 to select").arg(path));
            return false;
        }
    }
    if (!paths.empty()) m_window.selection().set(paths);
    return true;
}

bool ScreenshotRunner::runDone() const {
    const RunSession& session = m_window.session();
    const bool over = session.state() == RunState::Ended || session.state() == RunState::Start; // Start: the run was refused
    return over || (session.state() == RunState::Paused && session.results().time() > *m_options.runFor - 1e-9);
}

bool ScreenshotRunner::isStuck() const {
    return m_window.session().responses().seconds() > kTimeoutS &&
           !m_window.session().responses().unresponsiveController().isEmpty();
}

void ScreenshotRunner::take() {
    if (m_options.screenshot.isEmpty()) return;
    if (!m_window.grab().save(m_options.screenshot)) {
        printProblem(QStringLiteral("%1 could not be written").arg(m_options.screenshot));
        QApplication::exit(m_code = 2);
    }
}

} // namespace trundle
