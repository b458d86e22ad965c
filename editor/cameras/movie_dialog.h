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

/// What a movie can be of.
struct MovieOffer {
    std::shared_ptr<const Loaded> text; ///< the experiment as its text says now
    std::shared_ptr<const Loaded> run;  ///< the one that runs; null: none does
    std::vector<Command> commands;      ///< what was done to that by hand
    double runTime = 0;                 ///< s, how far that is
    /// Where the window's view looks from in a movie of a size.
    std::function<MovingView(std::uint32_t width, std::uint32_t height)> view;
    PictureRequest look; ///< as the window's view is drawn
    QSize shown;         ///< of that view
    QString file;        ///< to be suggested
};

/// Asks what the movie is to be, then records it: progress, cancel. The window can be worked with meanwhile.
class MovieDialog final : public QDialog {
    Q_OBJECT
public:
    MovieDialog(Parts& parts, RenderService& render, MovieOffer offer, QWidget* parent);

    /// What would be recorded now.
    [[nodiscard]] MovieJob job() const;
    [[nodiscard]] bool isRecording() const { return m_recorder->isRecording(); }

    /// How a file or folder is opened in another program; QDesktopServices unless set.
    void setOpener(std::function<void(const QString& path)> open) { m_opener = std::move(open); }

Q_SIGNALS:
    void recorded(const QString& path);

public Q_SLOTS:
    void record();
    void reject() override; ///< while it records: cancels the movie, and stays open

private:
    void addRows(QFormLayout& form);
    void showSource();
    void showSum();
    void showProgress(quint64 pictures, double time);
    void end(const QString& failure, bool cancelled);
    void offerMovie(bool made);
    void browse();
    void setBusy(bool busy);
    [[nodiscard]] bool ofRun() const;
    [[nodiscard]] std::shared_ptr<const ExperimentSpec> experiment() const;

    MovieOffer m_offer;
    std::function<void(const QString& path)> m_opener;
    MovieRecorder* m_recorder;
    MovieJob m_job; ///< in work
    QWidget* m_form = nullptr;
    QComboBox *m_what = nullptr, *m_source = nullptr;
    QDoubleSpinBox *m_begin = nullptr, *m_end = nullptr, *m_rate = nullptr;
    SizeChoice* m_size = nullptr;
    QLineEdit* m_file = nullptr;
    QLabel* m_sum = nullptr;
    QProgressBar* m_progress = nullptr;
    QPushButton *m_record = nullptr, *m_close = nullptr;
    QDialogButtonBox* m_box = nullptr;
    QPushButton *m_open = nullptr, *m_show = nullptr; ///< of the movie that was made
};

} // namespace trundle
