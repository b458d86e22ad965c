#pragma once
#include <QObject>
#include <QWidget>

#include "editor/widgets/actions.h"

namespace trundle {

class Application;
class Document;
class RenderService;
class RunSession;
class StatusLine;
class ViewportPanel;

/// Saves images and movies of the current view.
class CameraCommands final : public QObject {
    Q_OBJECT
public:
    struct Sources {
        Application& application;
        Document& document;
        RunSession& session;
        ViewportPanel& viewport;
        StatusLine& status;
        RenderService* render; ///< null without OpenGL
    };
    /// All sources must outlive this object.
    CameraCommands(QWidget& window, Actions& actions, const Sources& sources);

private:
    void savePicture();
    void recordMovie();
    [[nodiscard]] bool hasGraphics() const; ///< otherwise it says so
    [[nodiscard]] QString pictureFile(const QString& ending) const;

    QWidget& m_window;
    Sources m_sources;
};

} // namespace trundle
