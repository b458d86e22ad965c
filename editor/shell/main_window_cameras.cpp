// MainWindow: cameras, saving images, and movies.

#include <QDir>
#include <QFileInfo>

#include "editor/cameras/cameras_panel.h"
#include "editor/cameras/movie_dialog.h"
#include "editor/cameras/picture_dialog.h"
#include "editor/outline/outline_panel.h"
#include "editor/shell/main_window.h"
#include "editor/shell/status_line.h"
#include "editor/viewport/view/picture_request.h"
#include "editor/viewport/view/viewport_panel.h"

namespace trundle {

/// A file next to the experiment with its name; in the user's own folder if the project's is not writable.
QString MainWindow::pictureFile(const QString& ending) const {
    const QFileInfo text(QString::fromStdString(m_document->path()));
    const bool beside = !m_document->isNew() && !m_document->isSample(m_document->path()) && QFileInfo(text.path()).isWritable();
    return QDir(beside ? text.path() : QDir::homePath()).filePath(text.completeBaseName() + ending);
}

void MainWindow::connectCameras(Application& application, RenderService* render) {
    connect(m_cameras, &CamerasPanel::messageRequested, m_status, &StatusLine::refuse);
    connect(m_cameras, &CamerasPanel::lookThroughRequested, this, [this](const std::string& camera) {
        showViewport(true);
        m_viewport->current().camera().lookThrough(camera);
    });
    connect(m_outline, &OutlinePanel::lookThroughRequested, this, [this](const std::string& path) {
        showViewport(true);
        m_viewport->lookThrough(path);
    });
    const auto needsGraphics = [this, render] {
        if (!render) m_status->refuse(tr("Pictures need OpenGL, which is not available."));
        return render != nullptr;
    };
    connect(&m_actions->at("view.savePicture"), &QAction::triggered, this, [this, render, needsGraphics] {
        if (!needsGraphics()) return;
        View& view = m_viewport->current();
        auto* dialog = new PictureDialog(
            *render, [&view](std::uint32_t width, std::uint32_t height) { return stillRequest(view, width, height); },
            view.size(), pictureFile(QStringLiteral(".png")), this);
        connect(dialog, &PictureDialog::written, this,
                [this](const QString& path) { m_status->refuse(tr("Wrote %1").arg(path)); });
        dialog->open();
    });
    connect(&m_actions->at("sim.record"), &QAction::triggered, this, [this, &application, render, needsGraphics] {
        if (!needsGraphics()) return;
        if (auto* before = findChild<MovieDialog*>()) return before->raise(); // one movie at a time
        View& view = m_viewport->current();
        MovieDialogOptions options;
        if (const QString why = m_session->source().refusal(); !why.isEmpty()) return m_status->refuse(why);
        options.text = m_document->loaded();
        options.run = m_session->results().snapshot ? m_session->results().built : nullptr;
        options.commands = m_session->robots().all();
        options.runTime = m_session->results().time();
        options.view = [&view](std::uint32_t width, std::uint32_t height) { return view.camera().movingView(width, height); };
        options.shown = view.size();
        options.look = stillRequest(view, std::uint32_t(view.width()), std::uint32_t(view.height()));
        options.file = pictureFile(QStringLiteral(".mp4"));
        auto* dialog = new MovieDialog(application, *render, std::move(options), this);
        connect(dialog, &MovieDialog::recorded, this,
                [this](const QString& path) { m_status->refuse(tr("Wrote %1").arg(path)); });
        dialog->show();
    });
}

} // namespace trundle
