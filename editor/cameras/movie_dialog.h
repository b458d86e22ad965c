#pragma once
#include <QDialog>

#include "editor/cameras/movie_recorder.h"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QProgressBar;
class QDialogButtonBox;
class QPushButton;

namespace trundle {

class RunSession;
class SizeChoice;

/// What can be recorded.
struct MovieDialogOptions {
    std::shared_ptr<const LoadedProject> text; ///< the experiment as in its current text
    std::shared_ptr<const LoadedProject> run;  ///< the running one; null: none
    std::vector<Command> commands;             ///< commands given in that run
    double runTime = 0;                        ///< s, simulated time of that run
    /// Returns the viewport's moving camera for a movie of this size.
    std::function<MovingView(std::uint32_t width, std::uint32_t height)> view;
    PictureRequest look; ///< rendering options of the viewport
    QSize shown;         ///< size of the viewport
    QString file;        ///< suggested file
};

/// Asks for the options of a movie, then records it with progress and cancel. Not modal.
class MovieDialog final : public QDialog {
    Q_OBJECT
public:
    MovieDialog(Application& application, RenderService& render, MovieDialogOptions options, QWidget* parent);

    /// The job for the current options.
    [[nodiscard]] MovieJob job() const;
    [[nodiscard]] bool isRecording() const { return m_recorder->isRecording(); }

    /// Sets how a file or folder is opened in another program, false if no program opens it; default: QDesktopServices. For tests.
    void setOpener(std::function<bool(const QString& path)> open) { m_opener = std::move(open); }

Q_SIGNALS:
    void recorded(const QString& path);

public Q_SLOTS:
    void record();
    void reject() override; ///< while recording: cancels the movie and keeps the dialog open

private:
    void addRows(QFormLayout& form);
    void addButtons();
    void showSource();
    void showSum();
    void showProgress(quint64 pictures, double time);
    void end(const QString& failure, bool cancelled);
    void openMovieDialog(bool made);
    void browse();
    void setBusy(bool busy);
    [[nodiscard]] bool ofRun() const;
    [[nodiscard]] std::shared_ptr<const ExperimentSpec> experiment() const;

    MovieDialogOptions m_options;
    std::function<bool(const QString& path)> m_opener;
    MovieRecorder* m_recorder;
    MovieJob m_job; ///< being recorded
    QWidget* m_form = nullptr;
    QComboBox *m_what = nullptr, *m_source = nullptr;
    QDoubleSpinBox *m_begin = nullptr, *m_end = nullptr, *m_rate = nullptr;
    SizeChoice* m_size = nullptr;
    QLineEdit* m_file = nullptr;
    QLabel* m_sum = nullptr;
    QProgressBar* m_progress = nullptr;
    QPushButton *m_record = nullptr, *m_close = nullptr;
    QDialogButtonBox* m_box = nullptr;
    QPushButton *m_open = nullptr, *m_show = nullptr; ///< for the finished movie
};

} // namespace trundle
