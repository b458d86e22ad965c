#pragma once
// The Cameras dock: current images of the run's cameras, or those at the start poses of the text.

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include "editor/cameras/camera_tiles.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QScrollArea;
class QSplitter;
class QStackedWidget;
class QToolButton;

namespace trundle {

class Document;
class RenderService;
class RunSession;

/// Images are rendered in a worker thread, only for visible tiles, and rarely enough to leave most of the machine to the run and
/// the viewports. The panel does not affect the run: it reads published poses.
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
    [[nodiscard]] bool isSettled() const;
    /// Number of images rendered so far. For tests.
    [[nodiscard]] int drawnCount() const { return m_drawn; }

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
    QWidget* makeChoice();
    void follow();
    void listCameras();
    void showChosen();
    void moved();
    void pump();
    void take(const std::vector<CameraPicture>& pictures, double seconds);
    void filterList();
    void showFacts();
    void askAndSave();
    void showMenu(const std::string& camera, const QPoint& at);
    [[nodiscard]] QString pixelText(const CameraTiles::Tile& tile, std::uint32_t x, std::uint32_t y);
    [[nodiscard]] std::vector<CameraShot> outdated() const;

    Document& m_document;
    RunSession& m_session;
    CameraPainter* m_painter = nullptr;
    std::shared_ptr<const ExperimentSpec> m_experiment;
    ImageTime m_moment;
    std::vector<CameraModel> m_cameras;
    std::vector<std::string> m_names;       ///< names of the object ids in images, computed on demand
    std::uint64_t m_state = 1, m_asked = 0; ///< number of the current state (poses, experiment, modes); of the one requested
    int m_drawn = 0;
    bool m_untouched = true; ///< no selection by the user: the first few cameras are shown
    QTimer m_next;
    QElapsedTimer m_sinceAsked;
    double m_pauseMs = 0; ///< minimum interval until the next request

    QStackedWidget* m_pages = nullptr;
    QLabel *m_empty = nullptr, *m_facts = nullptr;
    QSplitter* m_halves = nullptr;
    QWidget* m_choice = nullptr;
    QLineEdit* m_filter = nullptr;
    QListWidget* m_list = nullptr;
    QScrollArea* m_scroll = nullptr;
    CameraTiles* m_wall = nullptr;
    QComboBox* m_mode = nullptr;
    QToolButton* m_save = nullptr;
};

} // namespace trundle
