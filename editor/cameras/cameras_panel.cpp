#include "editor/cameras/cameras_panel.h"

#include <algorithm>
#include <cmath>

#include <QComboBox>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QScrollArea>
#include <QSplitter>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "editor/cameras/camera_list.h"
#include "editor/document/document.h"
#include "editor/running/session.h"
#include "editor/widgets/controls.h"
#include "editor/widgets/empty_page.h"
#include "editor/widgets/save_question.h"
#include "editor/widgets/theme.h"
#include "model/object_numbers.h"
#include "scene/scene.h"

namespace trundle {

CamerasPanel::CamerasPanel(Document& document, RunSession& session, RenderService* render, QWidget* parent)
    : QWidget(parent), m_document(document), m_session(session) {
    setObjectName(QStringLiteral("CamerasPanel"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_pages = new QStackedWidget(this);
    column->addWidget(m_pages);
    m_empty = new QLabel;
    styleEmptyPage(*m_empty, "camerasEmpty");
    m_pages->addWidget(m_empty);
    m_pages->addWidget(makeWork());

    m_feed = new CameraFeed(render, *m_wall, this);
    connect(m_feed, &CameraFeed::shown, this, &CamerasPanel::pictureShown);
    connect(m_feed, &CameraFeed::saved, this, [this](const QString& path, const QString& failure) {
        const QString file = QString::fromStdString(m_document.texts().shown(path.toStdString()));
        Q_EMIT messageRequested(failure.isEmpty() ? tr("Wrote %1").arg(file) : failure);
    });
    connect(m_mode, &QComboBox::currentIndexChanged, this, [this] {
        const QVariant mode = m_mode->currentData();
        m_feed->setMode(mode.isValid() ? std::optional(CameraMode(mode.toInt())) : std::nullopt);
    });
    connect(&document, &Document::opened, m_list, &CameraList::reset);
    connect(&document, &Document::changed, this, [this](const ChangeSet& changes) {
        const auto& listed = m_feed->state().experiment;
        m_sameCameras = listed && changes.before() && changes.before()->experiment == listed && !changes.changesObjects() &&
                        !changes.changesProblems(); // an invalid camera is not listed
        follow();
        m_sameCameras = false;
    });
    connect(&session, &RunSession::experimentChanged, this, &CamerasPanel::follow);
    connect(&session, &RunSession::stateChanged, this, &CamerasPanel::follow);
    connect(&session, &RunSession::advanced, this, &CamerasPanel::follow);
    listCameras();
    follow();
    showFacts();
}

QWidget* CamerasPanel::makeWork() {
    auto* work = new QWidget;
    auto* rows = new QVBoxLayout(work);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    rows->addWidget(makeTools());
    auto* halves = new QSplitter(Qt::Horizontal);
    halves->setChildrenCollapsible(false);
    m_list = new CameraList;
    halves->addWidget(m_list);
    m_scroll = new QScrollArea;
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setWidgetResizable(true);
    m_wall = new CameraTiles;
    m_scroll->setWidget(m_wall);
    m_scroll->viewport()->installEventFilter(this);
    halves->addWidget(m_scroll);
    halves->setStretchFactor(1, 1);
    halves->setSizes({190, 800});
    rows->addWidget(halves, 1);

    m_wall->setPixelText([this](const auto& tile, std::uint32_t x, std::uint32_t y) { return pixelText(tile, x, y); });
    connect(m_wall, &CameraTiles::currentChanged, this, &CamerasPanel::showFacts);
    connect(m_wall, &CameraTiles::menuRequested, this, &CamerasPanel::showMenu);
    connect(m_list, &CameraList::chosenChanged, this, &CamerasPanel::showChosen);
    connect(m_list, &CameraList::currentChanged, m_wall, &CameraTiles::setCurrent);
    return work;
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
    showTextBesideIcon(*m_save);
    m_save->setToolTip(tr("Write the chosen picture to a file"));
    m_save->setAutoRaise(true);
    row->addWidget(m_mode);
    row->addWidget(m_facts, 1);
    row->addWidget(m_save);
    connect(m_save, &QToolButton::clicked, this, &CamerasPanel::askAndSave);
    return bar;
}

void CamerasPanel::follow() {
    const CameraState& before = m_feed->state();
    const bool runs = m_session.results().experiment && m_session.results().poses;
    CameraState now;
    now.experiment = runs ? m_session.results().experiment : m_document.isOpen() ? m_document.loaded()->experiment : nullptr;
    now.running = runs && m_session.state() == RunState::Running;
    const bool another = now.experiment != before.experiment;
    if (another) { // shows nothing until the tiles are those of the new cameras
        m_names.clear();
        m_feed->show(now);
        if (m_sameCameras) showChosen(); // of other sizes, perhaps
        else listCameras();
    }
    if (runs) {
        const LiveSnapshot& snapshot = *m_session.results().snapshot;
        now.moment = {m_session.results().poses, snapshot.tick, snapshot.time};
        now.images = snapshot.images;
    } else if (now.experiment) {
        const bool atStart = before.moment.poses && before.moment.tick == 0 && before.moment.time == 0 && !another;
        now.moment.poses = atStart ? before.moment.poses : std::make_shared<const BodyPoses>(startPoses(*now.experiment));
    }
    m_feed->show(std::move(now));
}

void CamerasPanel::listCameras() {
    std::vector<std::string> paths;
    for (const CameraModel& camera : m_feed->cameras()) paths.push_back(camera.path);
    m_list->setCameras(paths);
    m_list->setVisible(paths.size() > 1);
    m_empty->setText(!m_feed->canDraw()
                         ? tr("Pictures need OpenGL, which is not available.")
                         : tr("No robot here has a camera. Select a body of a robot, then choose Insert ▸ Camera."));
    m_pages->setCurrentIndex(paths.empty() || !m_feed->canDraw() ? 0 : 1);
}

void CamerasPanel::setChosen(const std::vector<std::string>& cameras) { m_list->setChosen(cameras); }

std::vector<std::string> CamerasPanel::chosen() const { return m_list->chosen(); }

void CamerasPanel::showChosen() {
    const std::vector<std::string> cameras = chosen();
    std::vector<std::pair<std::string, double>> shown;
    for (const CameraModel& camera : m_feed->cameras())
        if (std::ranges::find(cameras, camera.path) != cameras.end())
            shown.emplace_back(camera.path, double(camera.width) / std::max(1u, camera.height));
    m_wall->setCameras(shown);
    m_feed->update();
}

void CamerasPanel::setMode(std::optional<CameraMode> mode) { m_mode->setCurrentIndex(mode ? m_mode->findData(int(*mode)) : 0); }

void CamerasPanel::showFacts() {
    const CameraTiles::Tile* tile = m_wall->current();
    const bool there = tile && tile->picture.frame;
    m_save->setEnabled(there);
    if (!there) return m_facts->setText(tile || m_feed->cameras().empty() ? QString() : tr("Check a camera to see its image."));
    const CameraImage& frame = *tile->picture.frame;
    m_facts->setText(tr("%1  •  %2 × %3  •  t = %4 s")
                         .arg(QString::fromStdString(tile->camera), QString::number(frame.width), QString::number(frame.height),
                              QString::number(frame.time, 'f', 2)));
}

QString CamerasPanel::pixelText(const CameraTiles::Tile& tile, std::uint32_t x, std::uint32_t y) {
    const CameraImage& frame = *tile.picture.frame;
    const std::size_t i = std::size_t(y) * frame.width + x;
    if (i < frame.objects.size()) {
        if (m_names.empty() && m_feed->state().experiment) m_names = objectNames(*m_feed->state().experiment);
        const std::uint32_t object = frame.objects[i];
        return object > 0 && object < m_names.size() ? QString::fromStdString(m_names[object]) : tr("nothing");
    }
    if (i >= frame.depth.size()) return {};
    return std::isfinite(frame.depth[i]) ? tr("%1 m").arg(double(frame.depth[i]), 0, 'f', 2) : tr("nothing");
}

void CamerasPanel::savePicture(const QString& path) {
    const CameraTiles::Tile* tile = m_wall->current();
    const std::shared_ptr<const ExperimentSpec>& experiment = m_feed->state().experiment;
    if (tile && tile->picture.frame && experiment) m_feed->save(experiment, tile->picture, path);
}

void CamerasPanel::askAndSave() {
    const CameraTiles::Tile* tile = m_wall->current();
    if (!tile || !tile->picture.frame) return;
    const CameraPicture picture = tile->picture; // a copy: the run continues while the dialog is open
    const std::shared_ptr<const ExperimentSpec> experiment = m_feed->state().experiment;
    QString name = QString::fromStdString(tile->camera).replace(QLatin1Char('/'), QLatin1Char('_'));
    name += QStringLiteral("_%1s.png").arg(picture.frame->time, 0, 'f', 2);
    const QString folder = m_document.isNew() ? QString() : QFileInfo(QString::fromStdString(m_document.path())).path() + u'/';
    const QString path =
        askWhereToSave(this, tr("Save Picture"), folder + name, tr("Pictures (*.png *.jpg *.jpeg)"), QStringLiteral("png"));
    if (!path.isEmpty()) m_feed->save(experiment, picture, path);
}

void CamerasPanel::showMenu(const std::string& camera, const QPoint& at) {
    QMenu menu(this);
    menu.setObjectName(QStringLiteral("cameraMenu"));
    connect(menu.addAction(themedIcon(QStringLiteral("save")), tr("&Save Picture…")), &QAction::triggered, this,
            &CamerasPanel::askAndSave);
    connect(menu.addAction(themedIcon(QStringLiteral("kind-camera")), tr("&Look Through This Camera")), &QAction::triggered, this,
            [this, camera] { Q_EMIT lookThroughRequested(camera); });
    if (m_feed->cameras().size() > 1) {
        menu.addSeparator();
        connect(menu.addAction(tr("&Hide Camera")), &QAction::triggered, this, [this, camera] {
            std::vector<std::string> left = chosen();
            std::erase(left, camera);
            setChosen(left);
        });
    }
    menu.exec(at);
}

void CamerasPanel::showEvent(QShowEvent*) { m_feed->update(); }

void CamerasPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_save) m_save->setIcon(themedIcon(QStringLiteral("save")));
}

bool CamerasPanel::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_scroll->viewport() && event->type() == QEvent::Resize) m_wall->fit();
    return QWidget::eventFilter(watched, event);
}

} // namespace trundle
