#pragma once
// The Cameras dock: what the cameras of the run see now, or those of the text at its start.

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include "editor/cameras/camera_wall.h"

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

/// Pictures are drawn in a thread of their own, of what is seen alone, seldom enough that the run and the 3D views have most of the
/// machine. Nothing here reaches the run: it looks at published poses.
class CamerasPanel final : public QWidget {
    Q_OBJECT
public:
    /// `render` is null where no OpenGL is to be had. All outlive this.
    CamerasPanel(Document& document, RunSession& session, RenderService* render, QWidget* parent = nullptr);

    [[nodiscard]] CameraWall& wall() { return *m_wall; }
    /// Which cameras are shown; those that are not there are left out.
    void setChosen(const std::vector<std::string>& cameras);
    [[nodiscard]] std::vector<std::string> chosen() const;
    /// None: each as its Mode says.
    void setMode(std::optional<CameraMode> mode);
    /// As the file's ending says; the words for how it went follow with said().
    void savePicture(const QString& path);
    /// All that is seen of it is drawn as things stand now.
    [[nodiscard]] bool isSettled() const;
    /// Pictures drawn so far.
    [[nodiscard]] int drawnCount() const { return m_drawn; }

Q_SIGNALS:
    void lookThroughWanted(const std::string& camera); ///< "robot0/eye"
    void said(const QString& text);
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
    [[nodiscard]] QString reading(const CameraWall::Tile& tile, std::uint32_t x, std::uint32_t y);
    [[nodiscard]] std::vector<CameraShot> outdated() const;

    Document& m_document;
    RunSession& m_session;
    CameraPainter* m_painter = nullptr;
    std::shared_ptr<const ExperimentSpec> m_experiment;
    FrameMoment m_moment;
    std::vector<CameraModel> m_cameras;
    std::vector<std::string> m_names;       ///< of what numbers in measured pictures mean; made when asked for
    std::uint64_t m_state = 1, m_asked = 0; ///< counts what can be seen (poses, experiments, modes); of the pictures in work
    int m_drawn = 0;
    bool m_untouched = true; ///< nobody chose: the first few are shown
    QTimer m_next;
    QElapsedTimer m_sinceAsked;
    double m_pauseMs = 0; ///< until the next picture may be asked for

    QStackedWidget* m_pages = nullptr;
    QLabel *m_empty = nullptr, *m_facts = nullptr;
    QSplitter* m_halves = nullptr;
    QWidget* m_choice = nullptr;
    QLineEdit* m_filter = nullptr;
    QListWidget* m_list = nullptr;
    QScrollArea* m_scroll = nullptr;
    CameraWall* m_wall = nullptr;
    QComboBox* m_mode = nullptr;
    QToolButton* m_save = nullptr;
};

} // namespace trundle
