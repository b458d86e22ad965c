#include "editor/viewport/view/viewport_actions.h"

#include <QActionGroup>
#include <QCursor>
#include <QMenu>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/running/session.h"
#include "editor/viewport/context/view_settings.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/overlays/pinned_values.h"
#include "editor/viewport/overlays/trails.h"
#include "editor/viewport/tools/array_dialog.h"
#include "editor/viewport/tools/picking.h"
#include "editor/viewport/view/view_grid.h"
#include "editor/viewport/view/view_header.h"
#include "editor/widgets/actions.h"
#include "project/objects/object_location.h"
#include "render/service.h"

namespace trundle {
namespace {

struct ToolRow {
    const char* id;
    Tool tool;
};
constexpr ToolRow kToolRows[] = {{"tool.select", Tool::Select},     {"tool.move", Tool::Move},
                                 {"tool.rotate", Tool::Rotate},     {"tool.scale", Tool::Scale},
                                 {"tool.measure", Tool::Measure},   {"tool.drawWalls", Tool::DrawWalls},
                                 {"tool.drawLine", Tool::DrawLine}, {"tool.drawRoom", Tool::DrawRoom}};

struct JointRow {
    const char* id;
    const char* kind;
};
constexpr JointRow kJointRows[] = {{"tool.connectHinge", "Hinge"},         {"tool.connectSlider", "Slider"},
                                   {"tool.connectFixed", "Fixed"},         {"tool.connectBall", "Ball"},
                                   {"tool.connectUniversal", "Universal"}, {"tool.connectSuspension", "Suspension"}};

struct KindRow {
    const char* id;
    ViewKind kind;
};
constexpr KindRow kKindRows[] = {{"view.perspective", ViewKind::Perspective},
                                 {"view.parallel", ViewKind::Orthographic},
                                 {"view.top", ViewKind::Top},
                                 {"view.front", ViewKind::Front},
                                 {"view.side", ViewKind::Side},
                                 {"view.follow", ViewKind::Follow},
                                 {"view.chase", ViewKind::Chase}};

struct OverlayRow {
    const char* id;
    Overlay overlay;
};
constexpr OverlayRow kOverlayRows[] = {{"view.overlayGrid", kOverlayGrid},           {"view.overlayShadows", kOverlayShadows},
                                       {"view.overlayNames", kOverlayNames},         {"view.overlayTrails", kOverlayTrails},
                                       {"view.overlayJoints", kOverlayJoints},       {"view.overlayMass", kOverlayMass},
                                       {"view.overlayContacts", kOverlayContacts},   {"view.overlayCollision", kOverlayCollision},
                                       {"view.overlayWireframe", kOverlayWireframe}, {"view.overlayFrusta", kOverlayFrusta},
                                       {"view.overlayLobes", kOverlayLobes},         {"view.overlayLinks", kOverlayLinks},
                                       {"view.overlayCoverage", kOverlayCoverage},   {"view.overlayBeams", kOverlayBeams},
                                       {"view.overlayInertia", kOverlayInertia},     {"view.overlaySupport", kOverlaySupport}};

struct LookRow {
    const char* id;
    LookChoice look;
};
constexpr LookRow kLookRows[] = {
    {"view.lookAutomatic", LookChoice::Automatic}, {"view.lookFast", LookChoice::Fast}, {"view.lookRich", LookChoice::Rich}};

constexpr std::size_t kMaxCameras = 8; // entries in the menu

QString axisName(int axis) { return QString(QLatin1Char("XYZ"[axis])); }

} // namespace

ViewportActions::ViewportActions(const ViewContext& context, Actions& actions, ViewGrid& views, ViewBar& bar)
    : QObject(&views), m_context(context), m_actions(actions), m_views(views), m_bar(bar) {
    connectViews();
    connectTools();
    connectOverlays();
    connectPinned();
    connect(&m_context.settings, &ViewSettings::changed, this, &ViewportActions::showSettings);
    showSettings();
}

void ViewportActions::on(const char* id, const std::function<void()>& work) {
    connect(&m_actions.at(id), &QAction::triggered, this, work);
}

void ViewportActions::connectViews() {
    for (const KindRow& row : kKindRows) on(row.id, [this, kind = row.kind] { m_views.current().camera().setKind(kind); });
    for (const LookRow& row : kLookRows)
        on(row.id, [this, look = row.look] {
            m_context.settings.setLook(look);
            showSettings();
        });
    int count = 0;
    for (const char* id : {"view.one", "view.two", "view.three", "view.four"})
        on(id, [this, views = ++count] { m_views.setViewCount(views); });
    on("view.through", [this] { lookThroughSelectedCamera(); });
    on("view.frame", [this] { m_views.frameSelection(); });
    on("view.frameAll", [this] { m_views.frameAll(); });
    for (int i = 0; i < 4; ++i) {
        View& view = m_views.view(i);
        connect(&view, &View::menuRequested, this, [this, &view](const QPointF& at) { showMenu(view, at); });
    }
}

void ViewportActions::connectTools() {
    const auto start = [this](Tool tool) {
        m_context.settings.setTool(tool);
        const bool stays = tool == Tool::Select || tool == Tool::Move || tool == Tool::Rotate || tool == Tool::Scale;
        if (!stays) m_views.current().setFocus(); // its keys, Esc above all, wherever it was chosen
        showSettings();
    };
    for (const ToolRow& row : kToolRows) on(row.id, [start, tool = row.tool] { start(tool); });
    for (const JointRow& row : kJointRows)
        on(row.id, [this, start, kind = row.kind] {
            m_context.settings.setJointKind(kind);
            start(Tool::Connect);
        });
    on("tool.snap", [this] { m_context.settings.setSnaps(m_actions.at("tool.snap").isChecked()); });
    on("tool.snapSteps", [this] { m_bar.openSteps(); });
    on("tool.frame", [this] {
        const AxesOf axes = m_context.settings.axes();
        m_context.settings.setAxes(axes == AxesOf::World    ? AxesOf::Parent
                                   : axes == AxesOf::Parent ? AxesOf::Local
                                                            : AxesOf::World);
    });
    on("tool.drop", [this] { dropToFloor(m_context); });
    on("tool.align", [this] { askAlign(); });
    on("tool.distribute", [this] { askDistribute(); });
    on("tool.array", [this] { askArray(); });
}

void ViewportActions::showSettings() {
    for (const ToolRow& row : kToolRows) m_actions.at(row.id).setChecked(m_context.settings.tool() == row.tool);
    const bool connects = m_context.settings.tool() == Tool::Connect;
    for (const JointRow& row : kJointRows)
        m_actions.at(row.id).setChecked(connects && m_context.settings.jointKind() == row.kind);
    m_actions.at("tool.snap").setChecked(m_context.settings.snaps());
    for (const OverlayRow& row : kOverlayRows) m_actions.at(row.id).setChecked(m_context.settings.shows(row.overlay));
    for (const LookRow& row : kLookRows) m_actions.at(row.id).setChecked(m_context.settings.look() == row.look);
}

void ViewportActions::connectOverlays() {
    for (const OverlayRow& row : kOverlayRows)
        connect(&m_actions.at(row.id), &QAction::triggered, this,
                [this, overlay = row.overlay](bool on) { m_context.settings.show(overlay, on); });
    const auto reportRenderStyle = [this] {
        if (m_context.render) m_context.render->setLook(m_context.settings.look());
    };
    reportRenderStyle();
    connect(&m_context.settings, &ViewSettings::changed, this, reportRenderStyle);
    connect(&m_context.settings, &ViewSettings::changed, this, [this] {
        m_context.session.enable(RunSession::Extra::Contacts, m_context.settings.shows(kOverlayContacts));
        m_context.trails->setWanted(m_context.settings.shows(kOverlayTrails));
    });
}

/// What the action pins or unpins: the selection, or the run itself if nothing is selected.
std::vector<std::string> ViewportActions::pathsToPin() const {
    return m_context.selection.empty() ? std::vector<std::string>{""} : m_context.selection.paths();
}

void ViewportActions::connectPinned() {
    PinnedValues& pinned = *m_context.pinned;
    connect(&m_actions.at("view.pinValues"), &QAction::triggered, this,
            [this, &pinned](bool pins) { pinned.set(pathsToPin(), pins); });
    const auto check = [this, &pinned] {
        const std::vector<std::string> paths = pathsToPin();
        m_actions.at("view.pinValues").setChecked(std::ranges::all_of(paths, [&](const auto& p) { return pinned.contains(p); }));
    };
    const auto repaint = [this] { m_views.current().update(); }; // the overlay only
    connect(&m_context.selection, &Selection::changed, this, check);
    connect(&pinned, &PinnedValues::changed, this, check);
    connect(&pinned, &PinnedValues::changed, this, repaint);
    connect(&m_context.session.values(), &RunValues::changed, this, [&pinned, repaint] {
        if (!pinned.pins().empty()) repaint();
    });
}

/// Repeated calls cycle through the cameras of the selection, or through all if the selection has none.
void ViewportActions::lookThroughSelectedCamera() {
    std::vector<const CameraModel*> cameras = m_context.world.camerasOf(m_context.selection.current());
    if (cameras.empty())
        for (const CameraModel& camera : m_context.world.cameras()) cameras.push_back(&camera);
    if (cameras.empty()) {
        Q_EMIT m_context.document.refused(tr("No robot here has a camera."));
        return;
    }
    const auto at = std::ranges::find(cameras, m_views.current().camera().through());
    m_views.current().camera().lookThrough((at == cameras.end() || at + 1 == cameras.end() ? cameras.front() : *(at + 1))->path);
}

void ViewportActions::askAlign() {
    QMenu menu(&m_views);
    menu.setObjectName(QStringLiteral("alignMenu"));
    const std::pair<AlignTo, QString> places[] = {
        {AlignTo::Low, tr("lowest")}, {AlignTo::Middle, tr("middles")}, {AlignTo::High, tr("highest")}};
    for (int axis = 0; axis < 3; ++axis) {
        menu.addSeparator();
        for (const auto& [to, name] : places)
            connect(menu.addAction(tr("Along %1: %2").arg(axisName(axis), name)), &QAction::triggered, this,
                    [this, axis, to = to] { alignSelected(m_context, axis, to); });
    }
    menu.exec(QCursor::pos());
}

void ViewportActions::askDistribute() {
    QMenu menu(&m_views);
    menu.setObjectName(QStringLiteral("distributeMenu"));
    for (int axis = 0; axis < 3; ++axis)
        connect(menu.addAction(tr("Along %1").arg(axisName(axis))), &QAction::triggered, this,
                [this, axis] { distributeSelected(m_context, axis); });
    menu.exec(QCursor::pos());
}

void ViewportActions::askArray() {
    if (!m_context.document.isOpen()) return;
    if (m_context.selection.empty()) {
        Q_EMIT m_context.document.refused(tr("Select what to copy first."));
        return;
    }
    Vec3 spacing = Vec3::Constant(0.5);
    const auto objects = m_context.world.objectsOf(m_context.selection.current());
    if (!objects.empty()) {
        const Bounds box = m_context.world.boundsOf(objects.front());
        // 1.5 times the size of the object, rounded.
        if (!box.empty()) spacing = (10 * 1.5 * box.size()).array().ceil() / 10;
    }
    ArrayDialog dialog(spacing, int(m_context.selection.paths().size()), gridRefusal(m_context), gridIsTurned(m_context),
                       &m_views);
    if (dialog.exec() == QDialog::Accepted) copyInRows(m_context, dialog.copy());
}

void ViewportActions::showMenu(View& view, const QPointF& at) {
    // The menu applies to the clicked object, unless that is part of the selection.
    const std::vector<std::string> chain = pickChain(m_context.world, m_context.world.hitsAlong(view.camera().rayAt(at)));
    const bool selected =
        std::any_of(chain.begin(), chain.end(), [this](const std::string& path) { return m_context.selection.contains(path); });
    if (!chain.empty() && !chain.front().empty() && !selected) m_context.selection.select(chain.front());
    QMenu menu(&m_views);
    menu.setObjectName(QStringLiteral("viewMenu"));
    if (!m_context.selection.empty()) {
        for (const char* id : {"edit.cut", "edit.copy", "edit.paste", "edit.duplicate", "edit.group", "edit.delete"})
            menu.addAction(&m_actions.at(id));
        menu.addSeparator();
        if (m_context.selection.current().find('.') != std::string::npos) { // something of a robot or of scenery
            for (const char* id : {"parts.make", "parts.mirrorY", "parts.repeat"}) menu.addAction(&m_actions.at(id));
            menu.addSeparator();
        }
        for (const char* id : {"tool.drop", "tool.align", "tool.distribute", "tool.array"}) menu.addAction(&m_actions.at(id));
        menu.addSeparator();
    } else {
        menu.addAction(&m_actions.at("edit.paste"));
        menu.addSeparator();
    }
    for (const char* id : {"model.edit", "view.frame", "view.frameAll"}) menu.addAction(&m_actions.at(id));
    const std::vector<const CameraModel*> cameras = m_context.world.camerasOf(m_context.selection.current());
    for (std::size_t i = 0; i < cameras.size() && i < kMaxCameras; ++i)
        connect(menu.addAction(tr("Look Through %1").arg(QString::fromStdString(cameras[i]->path))), &QAction::triggered, &view,
                [&view, path = cameras[i]->path] { view.camera().lookThrough(path); });
    menu.addAction(&m_actions.at("view.pinValues"));
    menu.addAction(&m_actions.at("view.savePicture"));
    menu.exec(view.mapToGlobal(at.toPoint()));
}

} // namespace trundle
