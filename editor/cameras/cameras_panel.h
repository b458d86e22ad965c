#pragma once
// The Cameras dock: current images of the run's cameras, or those at the start poses of the text.

#include <QWidget>

#include "editor/cameras/camera_feed.h"
#include "editor/cameras/camera_tiles.h"

class QComboBox;
class QLabel;
class QScrollArea;
class QStackedWidget;
class QToolButton;

namespace trundle {

class CameraList;
class Document;
class RunSession;

/// The panel does not affect the run: it reads what the run publishes.
class CamerasPanel final : public QWidget {
    Q_OBJECT
public:
    /// `render` is null without OpenGL. All must outlive this object.
    CamerasPanel(Document& document, RunSession& session, RenderService* render, QWidget* parent = nullptr);

    [[nodiscard]] CameraTiles& wall() { return *m_wall; }
    /// Selects the cameras to show; unknown ones are ignored.
    void setChosen(const std::vector<std::string>& cameras);
    [[nodiscard]] std::vector<std::string> chosen() const;
    /// None: each camera's own mode.
    void setMode(std::optional<CameraMode> mode);
    /// The format follows from the file's extension; messageRequested() reports the result.
    void savePicture(const QString& path);
    /// All visible images are up to date. For tests.
    [[nodiscard]] bool isSettled() const { return m_feed->isSettled(); }
    /// Number of images rendered so far. For tests.
    [[nodiscard]] int drawnCount() const { return m_feed->drawnCount(); }

Q_SIGNALS:
    void lookThroughRequested(const std::string& camera); ///< path: "robot0/eye"
    void messageRequested(const QString& text);
    void pictureShown();

protected:
    void showEvent(QShowEvent*) override;
    void changeEvent(QEvent*) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* makeTools();
    QWidget* makeWork();
    void follow();
    void listCameras();
    void showChosen();
    void showFacts();
    void askAndSave();
    void showMenu(const std::string& camera, const QPoint& at);
    [[nodiscard]] QString pixelText(const CameraTiles::Tile& tile, std::uint32_t x, std::uint32_t y);

    Document& m_document;
    RunSession& m_session;
    std::vector<std::string> m_names; ///< names of the object ids in images, computed on demand

    QStackedWidget* m_pages = nullptr;
    QLabel *m_empty = nullptr, *m_facts = nullptr;
    CameraList* m_list = nullptr;
    QScrollArea* m_scroll = nullptr;
    CameraTiles* m_wall = nullptr;
    bool m_sameCameras = false; ///< during an edit that changes neither the cameras nor their names
    CameraFeed* m_feed = nullptr;
    QComboBox* m_mode = nullptr;
    QToolButton* m_save = nullptr;
};

} // namespace trundle
