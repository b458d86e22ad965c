#include "editor/viewport/view/viewport_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QTimer>
#include <QVBoxLayout>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/running/session.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/gizmo/transform_selection.h"
#include "editor/viewport/overlays/pinned_values.h"
#include "editor/viewport/radio/radio_overlays.h"
#include "editor/viewport/tools/measure_tool.h"
#include "editor/viewport/view/view_header.h"
#include "editor/widgets/actions.h"
#include "scene/queries/framing.h"

namespace trundle {
namespace {

constexpr ViewKind kKinds[] = {ViewKind::Perspective, ViewKind::Top, ViewKind::Front, ViewKind::Side};
constexpr double kLeastFramed = 0.1; // m

} // namespace

ViewportPanel::ViewportPanel(Document& document, Selection& selection, RunSession& session, RenderService* render,
                             Actions& actions, QWidget* parent)
    : QWidget(parent), m_document(document), m_selection(selection), m_session(session), m_actions(actions),
      m_measurement(std::make_unique<Measurement>()), m_world(std::make_unique<ViewportScene>(document, session, render)),
      m_trails(std::make_unique<Trails>(*m_world)), m_radios(std::make_unique<RadioOverlays>(*m_world, selection, m_settings)),
      m_pinned(std::make_unique<PinnedValues>()) {
    setObjectName(QStringLiteral("viewportPanel"));
    m_context.reset(new ViewContext{document, selection, session, *m_world, m_settings, *m_measurement, render, m_trails.get(),
                                    m_radios.get(), m_pinned.get()});
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(new ViewBar(m_settings, actions));

    m_columns = new QSplitter(Qt::Horizontal);
    makeBanner();
    m_left = new QSplitter(Qt::Vertical);
    m_right = new QSplitter(Qt::Vertical);
    m_columns->addWidget(m_left);
    m_columns->addWidget(m_right);
    column->addWidget(m_columns, 1);
    makeViews(render);
    connectActions();
    connectOverlays();
    connectPinned();
    setViewCount(1);
    connectFraming();
    connectBanner();
    connect(m_world.get(), &ViewportScene::posed, this, &ViewportPanel::followDrivenRobot);
}

/// Placed over the views, so that the layout does not change when it appears.
void ViewportPanel::makeBanner() {
    m_banner = new QFrame(this);
    m_banner->setObjectName(QStringLiteral("viewportBanner"));
    m_banner->setAutoFillBackground(true);
    static_cast<QFrame*>(m_banner)->setFrameShape(QFrame::StyledPanel);
    auto* words = new QHBoxLayout(m_banner);
    words->setContentsMargins(10, 4, 6, 4);
    m_bannerText = new QLabel;
    m_bannerText->setWordWrap(true);
    m_bannerButton = new QPushButton;
    m_bannerButton->setObjectName(QStringLiteral("bannerButton"));
    words->addWidget(m_bannerText, 1);
    words->addWidget(m_bannerButton);
    m_banner->hide();
}

void ViewportPanel::connectBanner() {
    for (const auto& signal : {&ViewportScene::replaced, &ViewportScene::posed})
        connect(m_world.get(), signal, this, &ViewportPanel::showBanner);
    connect(&m_selection, &Selection::changed, this, &ViewportPanel::showBanner);
    connect(&m_session, &RunSession::stateChanged, this, &ViewportPanel::showBanner);
    connect(&m_settings, &ViewSettings::changed, this, &ViewportPanel::showBanner);
    connect(m_bannerButton, &QPushButton::clicked, this, [this] {
        if (m_blockingLayout.empty()) return m_session.robots().keepPoses();
        (void)m_document.apply(tr("Replace %1 by single instances").arg(QString::fromStdString(m_blockingLayout)),
                               planReplaceBySingles(*m_document.loaded(), m_blockingLayout));
    });
}

/// A new document is framed once, as soon as it has objects.
void ViewportPanel::connectFraming() {
    connect(&m_document, &Document::opened, this, [this] {
        m_toBeFramed = true;
        for (View* view : m_views) // the followed robot is gone
            if (view->camera().free().kind() == ViewKind::Follow || view->camera().free().kind() == ViewKind::Chase)
                view->camera().setKind(ViewKind::Perspective);
    });
    connect(&m_document, &Document::changed, this, [this] { // emitted after opened(), before which the scene is outdated
        if (!m_toBeFramed || m_world->objects()->instances().empty()) return;
        m_toBeFramed = false;
        m_frameWhenShown = !isVisible();
        frameAll();
    });
    if (!m_world->objects()->instances().empty()) m_toBeFramed = false, m_frameWhenShown = true;
}

ViewportPanel::~ViewportPanel() {
    // The views refer to members of this panel, so they are deleted first.
    delete m_columns;
}

void ViewportPanel::makeViews(RenderService*) {
    for (int i = 0; i < 4; ++i) {
        auto* view = new View(*m_context, kKinds[i]);
        view->setObjectName(QStringLiteral("view%1").arg(i));
        new ViewCorner(*view);
        (i % 2 == 0 ? m_left : m_right)->addWidget(view);
        connect(view, &View::activated, this, [this, view] { setCurrent(*view); });
        connect(view, &View::menuRequested, this, [this, view](const QPointF& at) { showMenu(*view, at); });
        m_views.push_back(view);
    }
    m_current = m_views.front();
}

void ViewportPanel::setViewCount(int count) {
    m_shown = std::clamp(count, 1, 4);
    for (int i = 0; i < 4; ++i) {
        View* view = m_views[std::size_t(i)];
        const bool wasThere = view->isVisibleTo(this), isThere = m_shown == 3 ? i != 2 : i < m_shown; // 3: one left, two right
        view->setVisible(isThere);
        // A newly shown view is framed after it got its size.
        if (isThere && !wasThere) QTimer::singleShot(0, view, [this, view] { view->frame(m_world->bounds(), false); });
    }
    m_right->setVisible(m_shown > 1);
    if (m_shown > 1) m_columns->setSizes({1000, 1000});
    for (QSplitter* side : {m_left, m_right}) side->setSizes({1000, 1000});
    setCurrent(m_current->isVisibleTo(this) ? *m_current : *m_views.front());
}

void ViewportPanel::setCurrent(View& view) {
    m_current = &view;
    for (View* each : m_views) each->setCurrent(each == m_current, m_shown > 1 && each == m_current);
}

/// While a robot is driven by keyboard, the view moves when the robot would leave it.
void ViewportPanel::followDrivenRobot() {
    const std::string robot = m_session.robots().driven();
    const std::optional<Pose> pose = robot.empty() ? std::nullopt : m_session.robots().pose(robot);
    if (!pose || !m_current->isVisible() || m_current->camera().free().kind() != ViewKind::Perspective ||
        m_current->camera().through())
        return;
    const std::optional<QPointF> at = m_current->camera().pixelOf(pose->position);
    if (!at || !m_current->rect().contains(at->toPoint())) setKind(ViewKind::Follow);
}

void ViewportPanel::setKind(ViewKind kind) { m_current->camera().setKind(kind); }

bool ViewportPanel::showView(const QString& name) {
    for (const ViewKind kind : {ViewKind::Perspective, ViewKind::Orthographic, ViewKind::Top, ViewKind::Front, ViewKind::Side,
                                ViewKind::Follow, ViewKind::Chase}) {
        if (viewKindName(kind).compare(name, Qt::CaseInsensitive) != 0) continue;
        setKind(kind);
        if (kind == ViewKind::Top || kind == ViewKind::Front || kind == ViewKind::Side)
            m_current->frame(m_world->bounds(), false);
        return true;
    }
    const std::string view = name.toStdString();
    for (const ComponentSpec& look : m_world->objects()->experiment().looks) {
        if (look.kind != "View" || look.name != view) continue;
        m_current->camera().showNamed(view);
        return true;
    }
    return false;
}

std::optional<Vec3> ViewportPanel::insertionPoint() const {
    if (!m_current->isVisible()) return std::nullopt;
    const Vec3 point = m_current->camera().pointUnder(QRectF(m_current->rect()).center());
    const ViewCamera& camera = m_current->camera().free();
    constexpr double kFarthest = 3; // of the distance of the camera: towards the horizon the floor is too far away to be meant
    return (point - camera.view().eye).norm() <= kFarthest * camera.distance() ? point : camera.middle();
}

std::vector<ViewState> ViewportPanel::viewStates() const {
    std::vector<ViewState> viewStates;
    for (const View* view : m_views) viewStates.push_back({view->camera().free().kind(), view->camera().free().view()});
    return viewStates;
}

void ViewportPanel::setViewStates(const std::vector<ViewState>& viewStates, int shown) {
    m_toBeFramed = m_frameWhenShown = false;
    setViewCount(shown);
    for (std::size_t i = 0; i < m_views.size() && i < viewStates.size(); ++i) {
        m_views[i]->camera().setView(viewStates[i].camera);
        m_views[i]->camera().setKind(viewStates[i].kind);
    }
}

bool ViewportPanel::isUpToDate() const {
    return std::all_of(m_views.begin(), m_views.end(),
                       [](const View* view) { return !view->isVisible() || view->image().isUpToDate(); });
}

bool ViewportPanel::isSettled() const {
    if (m_radios->isComputing()) return false;
    return std::all_of(m_views.begin(), m_views.end(),
                       [](const View* view) { return !view->isVisible() || view->image().isSettled(); });
}

void ViewportPanel::frameSelection() {
    Bounds box;
    for (const std::string& path : m_selection.paths())
        for (const ObjectRef& object : m_world->objectsOf(path)) box.add(m_world->boundsOf(object));
    if (box.empty()) return frameAll();
    if (box.radius() < kLeastFramed) box.grow(kLeastFramed);
    box.grow(0.35 * box.radius());
    m_current->frame(box);
}

void ViewportPanel::frameAll() {
    const bool first = !m_current->isVisible() || m_current->image().picture().isNull();
    for (View* view : m_views) {
        if (view->camera().free().kind() == ViewKind::Perspective && m_world->objects()) {
            const auto width = std::uint32_t(std::max(16, view->width())), height = std::uint32_t(std::max(16, view->height()));
            const CameraView whole = defaultView(m_world->objects()->experiment(), *m_world->poses(), width, height);
            if (first || view != m_current) {
                view->camera().setView(whole);
                continue;
            }
        }
        view->frame(m_world->bounds(), view == m_current);
    }
}

void ViewportPanel::setHidden(const std::vector<std::string>& paths) { m_world->setHidden(paths); }
void ViewportPanel::setLocked(const std::vector<std::string>& paths) { m_world->setLocked(paths); }

void ViewportPanel::showBanner() {
    if (m_current && m_current->isMouseBusy() && !m_banner->isVisible()) return; // the tool shows its own message during a drag
    m_blockingLayout.clear();
    QString text, button;
    const Tool tool = m_settings.tool();
    const bool edits = tool == Tool::Move || tool == Tool::Rotate || tool == Tool::Scale;
    if (edits && !m_selection.empty() && m_document.isOpen()) {
        const TransformSelection held(*m_context, tool == Tool::Scale ? TransformSelection::Operation::Scale
                                                                      : TransformSelection::Operation::Move);
        text = held.refusal();
        m_blockingLayout = held.blockingLayout();
        if (!m_blockingLayout.empty()) button = tr("Replace by Single Instances");
        if (text.isEmpty() && tool == Tool::Scale) text = held.sizeRefusal();
        if (text.isEmpty() && tool == Tool::Scale && !held.empty() && held.halfExtent().isZero())
            text = m_world->isRunning() ? tr("Sizes can only change at the start of a run.")
                                        : tr("%1 has no size of its own: select a shape with repeated clicks.").arg(held.title());
    }
    if (text.isEmpty() && m_session.state() == RunState::Paused && edits && m_world->isRunning() &&
        m_session.robots().keepRefusal().isEmpty()) {
        text = tr("Moving objects during a run does not change their start in the text.");
        button = tr("Keep These Poses as Start");
    }
    m_bannerText->setText(text);
    m_bannerButton->setText(button);
    m_bannerButton->setVisible(!button.isEmpty());
    m_banner->setVisible(!text.isEmpty());
    placeBanner();
}

/// Below the corner button of the first view, since axes and scale bar are at the lower edge.
void ViewportPanel::placeBanner() {
    const int frame = m_banner->layout()->minimumSize().width() - m_bannerText->minimumSizeHint().width();
    const int wanted = frame + m_bannerText->fontMetrics().horizontalAdvance(m_bannerText->text()) + 4;
    const int wide = std::min(wanted, width() - 24);
    m_banner->setGeometry((width() - wide) / 2, m_columns->y() + 42, wide, m_banner->heightForWidth(wide));
    m_banner->raise();
}

void ViewportPanel::resizeEvent(QResizeEvent*) { placeBanner(); }

void ViewportPanel::showEvent(QShowEvent*) {
    // It was framed before it had a size.
    if (m_frameWhenShown) QTimer::singleShot(0, this, &ViewportPanel::frameAll);
    m_frameWhenShown = false;
}

} // namespace trundle
