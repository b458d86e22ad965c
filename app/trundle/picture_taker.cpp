#include "trundle/picture_taker.h"

#include <QApplication>
#include <QFileInfo>

#include "editor/widgets/actions.h"
#include "project/object_place.h"
#include "trundle/problem.h"

namespace trundle {

static constexpr double kPatienceS = 5;            // with a controller that does not come back
static constexpr int kNoRun = 1, kRunCutShort = 3; // said by --help

PictureTaker::PictureTaker(MainWindow& window, const WindowOptions& options) : m_window(window), m_options(options) {
    m_look.setInterval(10);
    if (m_options.quit) { // nobody is there to read a message in the window
        disconnect(&m_window.document(), &Document::openFailed, nullptr, nullptr);
        connect(&m_window.document(), &Document::openFailed, this, [this](const QString& path, const QString& reason) {
            refuse(reason.contains(path) ? reason : QStringLiteral("%1: %2").arg(path, reason));
        });
    }
    connect(&m_window.session(), &RunSession::refused, this, &PictureTaker::noRun);
    connect(&m_window.session(), &RunSession::ended, this, &PictureTaker::runEnded);
    connect(&m_look, &QTimer::timeout, this, &PictureTaker::next);
    m_look.start();
}

void PictureTaker::next() {
    switch (m_stage) {
    case Stage::Open:
        if (m_options.layout) m_window.setLayout(*m_options.layout);
        if (!m_options.look.isEmpty())
            m_window.actions()
                .at(m_options.look == QStringLiteral("rich")   ? "view.lookRich"
                    : m_options.look == QStringLiteral("fast") ? "view.lookFast"
                                                               : "view.lookAutomatic")
                .trigger();
        if (!m_options.open.isEmpty()) m_window.open(QFileInfo(m_options.open).absoluteFilePath());
        m_stage = Stage::Opening;
        break;
    case Stage::Opening:
        if (m_window.document().isOpening()) return;
        if (!select()) return;
        m_window.useView(m_options.view);
        m_stage = m_options.runFor && m_window.document().isOpen() ? Stage::Run : Stage::Draw;
        break;
    case Stage::Run:
        m_window.session().runFor(*m_options.runFor);
        m_stage = Stage::Running;
        break;
    case Stage::Running:
        if (isStuck()) say(m_window.session().heldUpText(), kRunCutShort);
        if (runDone() || m_code) m_stage = Stage::Draw;
        break;
    case Stage::Draw:
        if (!m_window.isSettled()) return;
        take();
        m_stage = Stage::Done;
        break;
    case Stage::Done:
        m_look.stop();
        if (m_options.quit) QApplication::exit(m_code);
        break;
    }
}

void PictureTaker::say(const QString& reason, int code) {
    printProblem(reason);
    m_code = code;
}

/// Instead of a picture. The window goes as it always does, so that nobody waits for what it held.
void PictureTaker::refuse(const QString& reason) {
    say(reason, 2);
    m_stage = Stage::Done;
}

/// The picture is taken all the same: of the start.
void PictureTaker::noRun(const QString& reason) {
    if (m_stage == Stage::Run) say(QStringLiteral("%1 did not run: %2").arg(m_options.open, reason), kNoRun);
}

void PictureTaker::runEnded(const Diagnostic& reason) {
    if (m_stage != Stage::Running) return;
    const QString why = QString::fromStdString(codeName(reason.code) + ": " + reason.message);
    const RunSession& session = m_window.session();
    if (!session.layout()) return say(QStringLiteral("%1 did not run: %2").arg(m_options.open, why), kNoRun);
    say(QStringLiteral("the run of %1 ended at t = %2 s: %3").arg(m_options.open, QString::number(session.end()->time), why),
        kRunCutShort);
}

bool PictureTaker::select() {
    std::vector<std::string> paths;
    const std::shared_ptr<const Loaded> loaded = m_window.document().loaded();
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

bool PictureTaker::runDone() const {
    const RunSession& session = m_window.session();
    const bool over = session.state() == RunState::Ended || session.state() == RunState::Start; // Start: it was refused
    return over || (session.state() == RunState::Paused && session.time() > *m_options.runFor - 1e-9);
}

bool PictureTaker::isStuck() const {
    return m_window.session().heldUpS() > kPatienceS && !m_window.session().heldUpBy().isEmpty();
}

void PictureTaker::take() {
    if (m_options.screenshot.isEmpty()) return;
    if (!m_window.grab().save(m_options.screenshot)) {
        printProblem(QStringLiteral("%1 could not be written").arg(m_options.screenshot));
        QApplication::exit(m_code = 2);
    }
}

} // namespace trundle
