#include "editor/cameras/cameras_panel.h"

#include <cmath>

#include <QComboBox>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QScrollArea>
#include <QSplitter>
#include <QStackedWidget>
#include <QToolButton>

#include "editor/document/document.h"
#include "editor/running/session.h"
#include "editor/widgets/save_question.h"
#include "editor/widgets/theme.h"
#include "scene/scene.h"

namespace trundle {
namespace {

constexpr std::size_t kFirstShown = 4;
constexpr double kLeastPauseMs = 66; // about 15 updates a second
constexpr double kShare = 1.0 / 3;   // largest share of one processor's time for these images

} // namespace

CamerasPanel::CamerasPanel(Document& document, RunSession& session, RenderService* render, QWidget* parent)
    : QWidget(parent), m_document(document), m_session(session) {
    setObjectName(QStringLiteral("CamerasPanel"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_pages = new QStackedWidget(this);
    column->addWidget(m_pages);
    m_empty = new QLabel;
    m_empty->setObjectName(QStringLiteral("camerasEmpty"));
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setWordWrap(true);
    m_empty->setMargin(16);
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    m_pages->addWidget(m_empty);

    auto* work = new QWidget;
    auto* rows = new QVBoxLayout(work);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    rows->addWidget(makeTools());
    m_halves = new QSplitter(Qt::Horizontal);
    m_halves->setChildrenCollapsible(false);
    m_halves->addWidget(makeChoice());
    m_scroll = new QScrollArea;
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setWidgetResizable(true);
    m_wall = new CameraTiles;
    m_scroll->setWidget(m_wall);
    m_scroll->viewport()->installEventFilter(this);
    m_halves->addWidget(m_scroll);
    m_halves->setStretchFactor(1, 1);
    m_halves->setSizes({190, 800});
    rows->addWidget(m_halves, 1);
    m_pages->addWidget(work);

    m_wall->setPixelText([this](const auto& tile, std::uint32_t x, std::uint32_t y) { return pixelText(tile, x, y); });
    connect(m_wall, &CameraTiles::uncovered, this, &CamerasPanel::pump);
    connect(m_wall, &CameraTiles::currentChanged, this, &CamerasPanel::showFacts);
    connect(m_wall, &CameraTiles::menuRequested, this, &CamerasPanel::showMenu);
    m_next.setSingleShot(true);
    connect(&m_next, &QTimer::timeout, this, &CamerasPanel::pump);
    if (render) {
        m_painter = new CameraPainter(*render, this);
        connect(m_painter, &CameraPainter::drawn, this, &CamerasPanel::take);
        connect(m_painter, &CameraPainter::saved, this, [this](const QString& path, const QString& failure) {
            Q_EMIT messageRequested(
                failure.isEmpty() ? tr("Wrote %1").arg(QString::fromStdString(m_document.shown(path.toStdString()))) : failure);
        });
    }
    connect(&document, &Document::opened, this, [this] {
        m_untouched = true;
        m_filter->clear();
    });
    connect(&document, &Document::changed, this, &CamerasPanel::follow);
    connect(&session, &RunSession::experimentChanged, this, &CamerasPanel::follow);
    connect(&session, &RunSession::stateChanged, this, &CamerasPanel::follow);
    connect(&session, &RunSession::advanced, this, &CamerasPanel::follow);
    follow();
    showFacts();
}

QWidget* CamerasPanel::makeTools() {
    auto* bar = new QWidget;
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(6, 4, 6, 4);
    row->setSpacing(6);
    m_mode = new QComboBox(bar);
    m_mode->setObjectName(QStringLiteral("cameraMode"));
    m_mode->setAccessibleName(tr("What the pictures show"));
    m_mode->setToolTip(tr("What the images show. The cameras do not change."));
    m_mode->addItem(tr("As each camera sees"));
    m_mode->addItem(tr("Colour"), int(CameraMode::Colour));
    m_mode->addItem(tr("Depth"), int(CameraMode::Depth));
    m_mode->addItem(tr("Segmentation"), int(CameraMode::Segmentation));
    m_facts = new QLabel(bar);
    m_facts->setObjectName(QStringLiteral("cameraFacts"));
    m_facts->setForegroundRole(QPalette::PlaceholderText);
    m_facts->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_facts->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_save = new QToolButton(bar);
    m_save->setObjectName(QStringLiteral("cameraSave"));
    m_save->setText(tr("Save Picture…"));
    m_save->setIcon(themedIcon(QStringLiteral("save")));
    m_save->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_save->setToolTip(tr("Write the chosen picture to a file"));
    m_save->setAutoRaise(true);
    row->addWidget(m_mode);
    row->addWidget(m_facts, 1);
    row->addWidget(m_save);
    connect(m_mode, &QComboBox::currentIndexChanged, this, &CamerasPanel::moved);
    connect(m_save, &QToolButton::clicked, this, &CamerasPanel::askAndSave);
    return bar;
}

QWidget* CamerasPanel::makeChoice() {
    m_choice = new QWidget;
    auto* column = new QVBoxLayout(m_choice);
    column->setContentsMargins(6, 0, 0, 6);
    column->setSpacing(4);
    m_filter = new QLineEdit;
    m_filter->setObjectName(QStringLiteral("cameraFilter"));
    m_filter->setPlaceholderText(tr("Filter…"));
    m_filter->setAccessibleName(tr("Filter the cameras"));
    m_filter->setClearButtonEnabled(true);
    m_list = new QListWidget;
    m_list->setObjectName(QStringLiteral("cameraList"));
    m_list->setAccessibleName(tr("Cameras"));
    m_list->setUniformItemSizes(true);
    m_list->setTextElideMode(Qt::ElideMiddle);
    m_choice->setMinimumWidth(120);
    column->addWidget(m_filter);
    column->addWidget(m_list, 1);
    connect(m_filter, &QLineEdit::textChanged, this, &CamerasPanel::filterList);
    connect(m_list, &QListWidget::itemChanged, this, [this] {
        m_untouched = false;
        showChosen();
    });
    connect(m_list, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
        if (item) m_wall->setCurrent(item->text().toStdString());
    });
    return m_choice;
}

// ---- list of cameras ----

void CamerasPanel::follow() {
    const bool runs = m_session.experiment() && m_session.poses();
    const std::shared_ptr<const ExperimentSpec> experiment = runs                  ? m_session.experiment()
                                                             : m_document.isOpen() ? m_document.loaded()->experiment
                                                                                   : nullptr;
    const bool another = experiment != m_experiment;
    if (another) {
        m_experiment = experiment;
        m_names.clear();
        m_moment.poses.reset();
        listCameras();
    }
    ImageTime now;
    if (runs) {
        now.poses = m_session.poses();
        now.tick = m_session.snapshot()->tick;
        now.time = m_session.snapshot()->time;
    } else if (experiment) {
        const bool stands = m_moment.poses && m_moment.tick == 0 && m_moment.time == 0 && !another;
        now.poses = stands ? m_moment.poses : std::make_shared<const BodyPoses>(startPoses(*experiment));
    }
    if (!another && now.poses == m_moment.poses && now.tick == m_moment.tick) return;
    m_moment = std::move(now);
    moved();
}

void CamerasPanel::listCameras() {
    const std::vector<std::string> before = chosen();
    m_cameras = m_experiment ? camerasOf(*m_experiment) : std::vector<CameraModel>();
    const bool touched = !m_untouched;
    {
        const QSignalBlocker quiet(m_list);
        const auto isSame = [this] {
            if (m_list->count() != int(m_cameras.size())) return false;
            for (int i = 0; i < m_list->count(); ++i)
                if (m_list->item(i)->text().toStdString() != m_cameras[std::size_t(i)].path) return false;
            return true;
        };
        if (!isSame()) {
            m_list->clear();
            for (const CameraModel& camera : m_cameras) {
                auto* item = new QListWidgetItem(QString::fromStdString(camera.path), m_list);
                item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
                item->setCheckState(Qt::Unchecked);
                item->setToolTip(item->text());
            }
        }
    }
    std::vector<std::string> wanted = before;
    if (!touched) {
        wanted.clear();
        for (std::size_t i = 0; i < m_cameras.size() && i < kFirstShown; ++i) wanted.push_back(m_cameras[i].path);
    }
    setChosen(wanted);
    m_untouched = !touched;
    filterList();
    m_choice->setVisible(m_cameras.size() > 1);
    m_empty->setText(!m_painter ? tr("Pictures need OpenGL, which is not available.")
                                : tr("No robot here has a camera. Select a body of a robot, then choose Insert ▸ Camera."));
    m_pages->setCurrentIndex(m_cameras.empty() || !m_painter ? 0 : 1);
}

void CamerasPanel::setChosen(const std::vector<std::string>& cameras) {
    {
        const QSignalBlocker quiet(m_list);
        for (int i = 0; i < m_list->count(); ++i) {
            const std::string name = m_list->item(i)->text().toStdString();
            const bool wanted = std::find(cameras.begin(), cameras.end(), name) != cameras.end();
            m_list->item(i)->setCheckState(wanted ? Qt::Checked : Qt::Unchecked);
        }
    }
    m_untouched = false;
    showChosen();
}

std::vector<std::string> CamerasPanel::chosen() const {
    std::vector<std::string> cameras;
    for (int i = 0; i < m_list->count(); ++i)
        if (m_list->item(i)->checkState() == Qt::Checked) cameras.push_back(m_list->item(i)->text().toStdString());
    return cameras;
}

void CamerasPanel::showChosen() {
    std::vector<std::pair<std::string, double>> shown;
    for (int i = 0; i < m_list->count() && std::size_t(i) < m_cameras.size(); ++i) {
        const CameraModel& camera = m_cameras[std::size_t(i)];
        if (m_list->item(i)->checkState() == Qt::Checked)
            shown.emplace_back(camera.path, double(camera.width) / std::max(1u, camera.height));
    }
    m_wall->setCameras(shown);
    pump();
}

void CamerasPanel::filterList() {
    const QString text = m_filter->text().trimmed();
    for (int i = 0; i < m_list->count(); ++i)
        m_list->item(i)->setHidden(!m_list->item(i)->text().contains(text, Qt::CaseInsensitive));
}

void CamerasPanel::setMode(std::optional<CameraMode> mode) { m_mode->setCurrentIndex(mode ? m_mode->findData(int(*mode)) : 0); }

// ---- images ----

void CamerasPanel::moved() {
    ++m_state;
    pump();
}

std::vector<CameraShot> CamerasPanel::outdated() const {
    std::vector<CameraShot> shots;
    if (!m_painter || !m_moment.poses) return shots;
    std::optional<CameraMode> mode;
    if (m_mode->currentData().isValid()) mode = CameraMode(m_mode->currentData().toInt());
    for (const CameraTiles::Tile* tile : m_wall->visibleTiles())
        if (tile->state != m_state) shots.push_back({tile->camera, mode});
    return shots;
}

/// Requests one batch at a time, always of the newest state, with a pause proportional to the duration of the last batch.
void CamerasPanel::pump() {
    if (!m_painter || m_painter->isBusy() || m_next.isActive() || outdated().empty()) return;
    const double since = m_sinceAsked.isValid() ? double(m_sinceAsked.elapsed()) : 1e9;
    if (since < m_pauseMs) return m_next.start(int(std::ceil(m_pauseMs - since)));
    m_sinceAsked.start();
    m_asked = m_state;
    m_painter->draw(m_experiment, m_moment, outdated());
}

void CamerasPanel::take(const std::vector<CameraPicture>& pictures, double seconds) {
    m_pauseMs = std::max(kLeastPauseMs, 1000 * seconds / kShare);
    m_drawn += int(pictures.size());
    for (const CameraPicture& picture : pictures) m_wall->setPicture(picture, m_asked);
    pump();
    Q_EMIT pictureShown();
}

bool CamerasPanel::isSettled() const { return !m_painter || (!m_painter->isBusy() && outdated().empty()); }

void CamerasPanel::showFacts() {
    const CameraTiles::Tile* tile = m_wall->current();
    const bool there = tile && tile->picture.frame;
    m_save->setEnabled(there);
    if (!there) return m_facts->setText(tile || m_cameras.empty() ? QString() : tr("Check a camera to see its image."));
    const CameraImage& frame = *tile->picture.frame;
    m_facts->setText(tr("%1  •  %2 × %3  •  t = %4 s")
                         .arg(QString::fromStdString(tile->camera), QString::number(frame.width), QString::number(frame.height),
                              QString::number(frame.time, 'f', 2)));
}

QString CamerasPanel::pixelText(const CameraTiles::Tile& tile, std::uint32_t x, std::uint32_t y) {
    const CameraImage& frame = *tile.picture.frame;
    const std::size_t i = std::size_t(y) * frame.width + x;
    if (i < frame.objects.size()) {
        if (m_names.empty() && m_experiment) m_names = objectNames(*m_experiment);
        const std::uint32_t object = frame.objects[i];
        return object > 0 && object < m_names.size() ? QString::fromStdString(m_names[object]) : tr("nothing");
    }
    if (i >= frame.depth.size()) return {};
    return std::isfinite(frame.depth[i]) ? tr("%1 m").arg(double(frame.depth[i]), 0, 'f', 2) : tr("nothing");
}

void CamerasPanel::savePicture(const QString& path) {
    const CameraTiles::Tile* tile = m_wall->current();
    if (m_painter && tile && tile->picture.frame && m_experiment) m_painter->save(m_experiment, tile->picture, path);
}

void CamerasPanel::askAndSave() {
    const CameraTiles::Tile* tile = m_wall->current();
    if (!tile || !tile->picture.frame) return;
    const CameraPicture picture = tile->picture; // a copy: the run continues while the dialog is open
    const std::shared_ptr<const ExperimentSpec> experiment = m_experiment;
    QString name = QString::fromStdString(tile->camera).replace(QLatin1Char('/'), QLatin1Char('_'));
    name += QStringLiteral("_%1s.png").arg(picture.frame->time, 0, 'f', 2);
    const QString folder = m_document.isNew() ? QString() : QFileInfo(QString::fromStdString(m_document.path())).path() + u'/';
    const QString path =
        askWhereToSave(this, tr("Save Picture"), folder + name, tr("Pictures (*.png *.jpg *.jpeg)"), QStringLiteral("png"));
    if (!path.isEmpty()) m_painter->save(experiment, picture, path);
}

void CamerasPanel::showMenu(const std::string& camera, const QPoint& at) {
    QMenu menu(this);
    menu.setObjectName(QStringLiteral("cameraMenu"));
    connect(menu.addAction(themedIcon(QStringLiteral("save")), tr("&Save Picture…")), &QAction::triggered, this,
            &CamerasPanel::askAndSave);
    connect(menu.addAction(themedIcon(QStringLiteral("kind-camera")), tr("&Look Through This Camera")), &QAction::triggered, this,
            [this, camera] { Q_EMIT lookThroughRequested(camera); });
    if (m_cameras.size() > 1) {
        menu.addSeparator();
        connect(menu.addAction(tr("&Hide Camera")), &QAction::triggered, this, [this, camera] {
            std::vector<std::string> left = chosen();
            std::erase(left, camera);
            setChosen(left);
        });
    }
    menu.exec(at);
}

void CamerasPanel::showEvent(QShowEvent*) { pump(); }

void CamerasPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_save) m_save->setIcon(themedIcon(QStringLiteral("save")));
}

bool CamerasPanel::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_scroll->viewport() && event->type() == QEvent::Resize) m_wall->fit();
    return QWidget::eventFilter(watched, event);
}

} // namespace trundle
