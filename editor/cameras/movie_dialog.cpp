#include "editor/cameras/movie_dialog.h"

#include <QComboBox>
#include <QDesktopServices>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QUrl>

#include "base/platform/piped_process.h"
#include "editor/cameras/size_choice.h"
#include "editor/widgets/save_question.h"
#include "scene/queries/camera_model.h"
#include "scene/queries/framing.h"

namespace trundle {
namespace {

enum class MovieSource { Shown, View, Camera };
constexpr int kName = Qt::UserRole + 1;

QDoubleSpinBox* secondsBox(const char* name) {
    auto* box = new QDoubleSpinBox;
    box->setObjectName(QLatin1String(name));
    box->setDecimals(2);
    box->setRange(0, 1e6);
    box->setSuffix(MovieDialog::tr(" s"));
    return box;
}

} // namespace

MovieDialog::MovieDialog(Application& application, RenderService& render, MovieDialogOptions options, QWidget* parent)
    : QDialog(parent), m_options(std::move(options)), m_recorder(new MovieRecorder(application, render, this)) {
    setObjectName(QStringLiteral("movieDialog"));
    setWindowTitle(tr("Record Movie"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* column = new QVBoxLayout(this);
    column->setSpacing(12);
    m_form = new QWidget;
    auto* form = new QFormLayout(m_form);
    form->setContentsMargins(0, 0, 0, 0);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    column->addWidget(m_form);
    addRows(*form);
    m_progress = new QProgressBar;
    m_progress->setObjectName(QStringLiteral("movieProgress"));
    m_progress->hide();
    m_sum = new QLabel;
    m_sum->setObjectName(QStringLiteral("movieSum"));
    m_sum->setWordWrap(true);
    m_sum->setMinimumWidth(440);
    m_sum->setMinimumHeight(2 * fontMetrics().lineSpacing());
    m_sum->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    column->addWidget(m_sum);
    column->addWidget(m_progress);
    addButtons();
    column->addWidget(m_box);
    for (QPushButton* button : findChildren<QPushButton*>())
        button->setAutoDefault(false); // else Enter would press the focused button
    m_record->setDefault(true);
    connect(m_recorder, &MovieRecorder::progressed, this, &MovieDialog::showProgress);
    connect(m_recorder, &MovieRecorder::finished, this, &MovieDialog::end);
    showSource();
    if (isInstalled("ffmpeg")) return;
    m_form->setEnabled(false);
    m_record->setEnabled(false);
    m_sum->setText(tr("Recording needs ffmpeg, which is not installed: sudo apt-get install ffmpeg"));
}

void MovieDialog::addButtons() {
    m_box = new QDialogButtonBox;
    m_close = m_box->addButton(QDialogButtonBox::Close);
    m_record = m_box->addButton(tr("&Record"), QDialogButtonBox::ActionRole);
    m_record->setObjectName(QStringLiteral("movieRecord"));
    m_close->setObjectName(QStringLiteral("movieClose"));
    m_open = new QPushButton(tr("Ope&n"), this);
    m_show = new QPushButton(tr("Show in &Folder"), this);
    m_open->setObjectName(QStringLiteral("movieOpen"));
    m_show->setObjectName(QStringLiteral("movieShowInFolder"));
    connect(m_open, &QPushButton::clicked, this, [this] {
        const QString movie = QString::fromStdString(m_job.path);
        if (!m_opener(movie)) m_sum->setText(tr("No program for movies is available. The movie is %1").arg(movie));
    });
    connect(m_show, &QPushButton::clicked, this, [this] {
        const QString movie = QString::fromStdString(m_job.path);
        if (!m_opener(QFileInfo(movie).absolutePath()))
            m_sum->setText(tr("No file manager is available. The movie is %1").arg(movie));
    });
    m_opener = [](const QString& path) { return QDesktopServices::openUrl(QUrl::fromLocalFile(path)); };
    openMovieDialog(false);
    connect(m_record, &QPushButton::clicked, this, &MovieDialog::record);
    connect(m_close, &QPushButton::clicked, this, &MovieDialog::reject);
}

void MovieDialog::addRows(QFormLayout& form) {
    m_what = new QComboBox;
    m_what->setObjectName(QStringLiteral("movieWhat"));
    m_source = new QComboBox;
    m_source->setObjectName(QStringLiteral("movieSource"));
    m_source->addItem(tr("The experiment, from its start"));
    if (m_options.run) m_source->addItem(tr("This run, repeated with all its commands"));
    m_source->setCurrentIndex(m_source->count() - 1);
    m_begin = secondsBox("movieBegin");
    m_end = secondsBox("movieEnd");
    auto* times = new QHBoxLayout;
    times->addWidget(m_begin, 1);
    times->addWidget(new QLabel(tr("to")));
    times->addWidget(m_end, 1);
    m_size = new SizeChoice(m_options.shown);
    m_size->setSize({1280, 720});
    m_rate = new QDoubleSpinBox;
    m_rate->setObjectName(QStringLiteral("movieRate"));
    m_rate->setDecimals(1);
    m_rate->setRange(0.1, 1000);
    m_rate->setValue(30);
    m_rate->setSuffix(tr(" for each simulated second"));
    m_file = new QLineEdit(QDir::toNativeSeparators(m_options.file));
    m_file->setObjectName(QStringLiteral("movieFile"));
    auto* choose = new QPushButton(tr("&Browse…"));
    auto* path = new QHBoxLayout;
    path->addWidget(m_file, 1);
    path->addWidget(choose);
    form.addRow(tr("&Show"), m_what);
    form.addRow(tr("&Of"), m_source);
    form.addRow(tr("From"), times);
    form.addRow(tr("Si&ze"), m_size);
    form.addRow(tr("&Pictures"), m_rate);
    form.addRow(tr("File"), path);
    connect(m_source, &QComboBox::currentIndexChanged, this, &MovieDialog::showSource);
    connect(choose, &QPushButton::clicked, this, &MovieDialog::browse);
    connect(m_what, &QComboBox::currentIndexChanged, this, &MovieDialog::showSum);
    connect(m_size, &SizeChoice::changed, this, &MovieDialog::showSum);
    connect(m_file, &QLineEdit::textChanged, this, &MovieDialog::showSum);
    for (QDoubleSpinBox* box : {m_begin, m_end, m_rate}) connect(box, &QDoubleSpinBox::valueChanged, this, &MovieDialog::showSum);
}

bool MovieDialog::ofRun() const { return m_source->currentIndex() == 1; }

std::shared_ptr<const ExperimentSpec> MovieDialog::experiment() const {
    return (ofRun() ? m_options.run : m_options.text)->experiment;
}

/// Lists the viewpoints and cameras of the selected experiment.
void MovieDialog::showSource() {
    const QString chosen = m_what->currentText();
    const auto experiment = this->experiment();
    {
        const QSignalBlocker quiet(m_what);
        m_what->clear();
        const auto add = [this](const QString& text, MovieSource what, const std::string& name) {
            m_what->addItem(text, int(what));
            m_what->setItemData(m_what->count() - 1, QString::fromStdString(name), kName);
        };
        add(tr("The 3D view as shown now"), MovieSource::Shown, {});
        for (const ComponentSpec& look : experiment->looks)
            if (look.kind == "View") add(tr("View %1").arg(QString::fromStdString(look.name)), MovieSource::View, look.name);
        for (const CameraModel& camera : camerasOf(*experiment))
            add(tr("Camera %1").arg(QString::fromStdString(camera.path)), MovieSource::Camera, camera.path);
        m_what->setCurrentIndex(std::max(0, m_what->findText(chosen)));
    }
    const double duration = experiment->settings.duration > 0 ? experiment->settings.duration : 10;
    m_begin->setValue(0);
    m_end->setValue(ofRun() ? m_options.runTime : duration);
    showSum();
}

MovieJob MovieDialog::job() const {
    MovieJob job;
    job.loaded = ofRun() ? m_options.run : m_options.text;
    if (ofRun()) job.commands = m_options.commands;
    job.begin = m_begin->value();
    job.end = m_end->value();
    job.look = m_options.look;
    const QSize size = m_size->size();
    job.look.width = std::uint32_t(size.width());
    job.look.height = std::uint32_t(size.height());
    const std::string name = m_what->currentData(kName).toString().toStdString();
    switch (MovieSource(m_what->currentData().toInt())) {
    case MovieSource::Camera: job.camera = name; break;
    case MovieSource::Shown: job.view = m_options.view(job.look.width, job.look.height); break;
    case MovieSource::View:
        job.look.hidden.clear();
        job.view = [experiment = experiment(), name](const BodyPoses& poses) {
            return namedView(*experiment, name, poses).value_or(CameraView());
        };
    }
    job.framesPerSecond = m_rate->value();
    job.path = QDir::fromNativeSeparators(m_file->text().trimmed()).toStdString();
    return job;
}

void MovieDialog::showSum() {
    const bool camera = MovieSource(m_what->currentData().toInt()) == MovieSource::Camera;
    m_size->setEnabled(!camera);
    const QString path = m_file->text().trimmed();
    QString why;
    if (m_end->value() < m_begin->value()) why = tr("The end time must be after the start time.");
    else if (!path.endsWith(QStringLiteral(".mp4"), Qt::CaseInsensitive) &&
             !path.endsWith(QStringLiteral(".webm"), Qt::CaseInsensitive))
        why = tr("The file name must end in .mp4 or .webm.");
    else if (!QFileInfo(path).absoluteDir().exists()) why = tr("The folder does not exist.");
    m_record->setEnabled(why.isEmpty());
    if (!why.isEmpty()) return m_sum->setText(why);
    const MovieJob wanted = job();
    QString text = tr("%L1 pictures, %2 s when played").arg(wanted.frameCount()).arg(wanted.end - wanted.begin, 0, 'f', 2);
    if (camera) text += tr(", in the camera's own size");
    if (QFileInfo::exists(path)) text += tr(". The file exists and will be replaced");
    m_sum->setText(text + u'.');
}

void MovieDialog::openMovieDialog(bool made) {
    for (QPushButton* button : {m_open, m_show}) {
        if (made) {
            m_box->addButton(button, QDialogButtonBox::ActionRole);
            button->show();
            continue;
        }
        m_box->removeButton(button); // if only hidden, the button box would show it again when the style changes
        button->setParent(this);
        button->hide();
    }
    (made ? m_open : m_record)->setDefault(true);
}

void MovieDialog::browse() {
    const QString path = askWhereToSave(this, tr("Record Movie"), m_file->text(), tr("Movies (*.mp4 *.webm)"),
                                        QStringLiteral("mp4"), QFileDialog::DontConfirmOverwrite);
    if (!path.isEmpty()) m_file->setText(QDir::toNativeSeparators(path));
}

// ---- while recording ----

void MovieDialog::setBusy(bool busy) {
    if (busy) openMovieDialog(false);
    m_form->setEnabled(!busy);
    m_record->setEnabled(!busy);
    m_close->setText(busy ? tr("Cancel") : tr("Close"));
    m_progress->setVisible(busy);
}

void MovieDialog::record() {
    if (m_recorder->isRecording()) return;
    m_job = job();
    m_progress->setRange(0, int(std::min<std::uint64_t>(m_job.frameCount(), 1'000'000'000)));
    m_progress->setValue(0);
    setBusy(true);
    m_sum->setText(tr("Preparing…"));
    m_recorder->start(m_job);
}

void MovieDialog::showProgress(quint64 pictures, double time) {
    m_progress->setValue(int(std::min<quint64>(pictures, 1'000'000'000)));
    m_sum->setText(pictures == 0 ? tr("Simulating to the start time: t = %1 s").arg(time, 0, 'f', 1)
                                 : tr("Picture %L1 of %L2, t = %3 s").arg(pictures).arg(m_job.frameCount()).arg(time, 0, 'f', 1));
}

void MovieDialog::end(const QString& failure, bool cancelled) {
    setBusy(false);
    const QString path = QDir::toNativeSeparators(QString::fromStdString(m_job.path));
    if (cancelled) m_sum->setText(tr("Cancelled: nothing was written."));
    else if (!failure.isEmpty()) m_sum->setText(failure);
    else {
        m_sum->setText(tr("Wrote %1").arg(path));
        openMovieDialog(true);
        Q_EMIT recorded(path);
    }
}

void MovieDialog::reject() {
    if (!m_recorder->isRecording()) return QDialog::reject();
    m_sum->setText(tr("Cancelling…"));
    m_recorder->cancel();
}

} // namespace trundle
