#include "editor/shell/commands/camera_commands.h"

#include <QDir>
#include <QFileInfo>

#include "editor/cameras/movie_dialog.h"
#include "editor/cameras/picture_dialog.h"
#include "editor/document/document.h"
#include "editor/running/session.h"
#include "editor/shell/status_line.h"
#include "editor/viewport/view/picture_request.h"
#include "editor/viewport/view/viewport_panel.h"

namespace trundle {

CameraCommands::CameraCommands(QWidget& window, Actions& actions, const Sources& sources)
    : QObject(&window), m_window(window), m_sources(sources) {
    connect(&actions.at("view.savePicture"), &QAction::triggered, this, &CameraCommands::savePicture);
    connect(&actions.at("sim.record"), &QAction::triggered, this, &CameraCommands::recordMovie);
}

/// A file next to the experiment with its name; in the user's own folder if the project's is not writable.
QString CameraCommands::pictureFile(const QString& ending) const {
    const Document& document = m_sources.document;
    const QFileInfo text(QString::fromStdString(document.path()));
    const bool beside = !document.isNew() && !document.texts().isSample(document.path()) && QFileInfo(text.path()).isWritable();
    return QDir(beside ? text.path() : QDir::homePath()).filePath(text.completeBaseName() + ending);
}

bool CameraCommands::hasGraphics() const {
    if (!m_sources.render) m_sources.status.refuse(tr("Pictures need OpenGL, which is not available."));
    return m_sources.render != nullptr;
}

void CameraCommands::savePicture() {
    if (!hasGraphics()) return;
    View& view = m_sources.viewport.views().current();
    auto* dialog = new PictureDialog(
        *m_sources.render, [&view](std::uint32_t width, std::uint32_t height) { return stillRequest(view, width, height); },
        view.size(), pictureFile(QStringLiteral(".png")), &m_window);
    connect(dialog, &PictureDialog::written, this,
            [this](const QString& path) { m_sources.status.refuse(tr("Wrote %1").arg(path)); });
    dialog->open();
}

void CameraCommands::recordMovie() {
    if (!hasGraphics()) return;
    if (auto* before = m_window.findChild<MovieDialog*>()) return before->raise(); // one movie at a time
    RunSession& session = m_sources.session;
    if (const QString why = session.source().refusal(); !why.isEmpty()) return m_sources.status.refuse(why);
    View& view = m_sources.viewport.views().current();
    MovieDialogOptions options;
    options.text = m_sources.document.loaded();
    options.run = session.results().snapshot ? session.results().built : nullptr;
    options.commands = session.robots().all();
    options.runTime = session.results().time();
    options.view = [&view](std::uint32_t width, std::uint32_t height) { return view.camera().movingView(width, height); };
    options.shown = view.size();
    options.look = stillRequest(view, std::uint32_t(view.width()), std::uint32_t(view.height()));
    options.file = pictureFile(QStringLiteral(".mp4"));
    auto* dialog = new MovieDialog(m_sources.application, *m_sources.render, std::move(options), &m_window);
    connect(dialog, &MovieDialog::recorded, this,
            [this](const QString& path) { m_sources.status.refuse(tr("Wrote %1").arg(path)); });
    dialog->show();
}

} // namespace trundle
