// Handlers of the window's actions in the viewport panel.

#include <QActionGroup>
#include <QCursor>
#include <QMenu>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/running/session.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/overlays/pinned_values.h"
#include "editor/viewport/tools/array_dialog.h"
#include "editor/viewport/tools/picking.h"
#include "editor/viewport/view/view_header.h"
#include "editor/viewport/view/viewport_panel.h"
#include "editor/widgets/actions.h"
#include "project/edits/path_after_edit.h"
#include "project/objects/object_location.h"
#include "render/service.h"

namespace trundle {
namespace {

struct ToolRow {
    const char* id;
    Tool tool;
};
constexpr ToolRow kTools[] = {{"tool.select", Tool::Select},
                              {"tool.move", Tool::Move},
                              {"tool.rotate", Tool::Rotate},
                              {"tool.scale", Tool::Scale},
                              {"tool.measure", Tool::Measure}};

struct KindRow {
    const char* id;
    ViewKind kind;
};
constexpr KindRow kKinds[] = {{"view.perspective", ViewKind::Perspective},
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
constexpr OverlayRow kOverlays[] = {{"view.overlayGrid", kOverlayGrid},           {"view.overlayShadows", kOverlayShadows},
                                    {"view.overlayNames", kOverlayNames},         {"view.overlayTrails", kOverlayTrails},
                                    {"view.overlayJoints", kOverlayJoints},       {"view.overlayMass", kOverlayMass},
                                    {"view.overlayContacts", kOverlayContacts},   {"view.overlayCollision", kOverlayCollision},
                                    {"view.overlayWireframe", kOverlayWireframe}, {"view.overlayFrusta", kOverlayFrusta},
                                    {"view.overlayLobes", kOverlayLobes},         {"view.overlayLinks", kOverlayLinks},
                                    {"view.overlayCoverage", kOverlayCoverage}};

struct LookRow {
    const char* id;
    LookChoice look;
};
constexpr LookRow kLooks[] = {
    {"view.lookAutomatic", LookChoice::Automatic}, {"view.lookFast", LookChoice::Fast}, {"view.lookRich", LookChoice::Rich}};

constexpr std::size_t kMaxCameras = 8; // entries in the menu

QString axisName(int axis) { return QString(QLatin1Char("XYZ"[axis])); }

} // namespace

void ViewportPanel::connectActions() {
    const auto on = [this](const char* id, auto&& work) { connect(&m_actions.at(id), &QAction::triggered, this, work); };
    for (const ToolRow& row : kTools)
        on(row.id, [this, tool = row.tool] {
            m_settings.setTool(tool);
            showTools();
        });
    for (const KindRow& row : kKinds) on(row.id, [this, kind = row.kind] { setKind(kind); });
    for (const LookRow& row : kLooks)
        on(row.id, [this, look = row.look] {
            m_settings.setLook(look);
            showTools();
        });
    on("view.one", [this] { setViewCount(1); });
    on("view.two", [this] { setViewCount(2); });
    on("view.three", [this] { setViewCount(3); });
    on("view.four", [this] { setViewCount(4); });
    on("view.through", [this] { lookThroughSelectedCamera(); });
    on("view.frame", [this] { frameSelection(); });
    on("view.frameAll", [this] { frameAll(); });
    on("tool.snap", [this] { m_settings.setSnaps(m_actions.at("tool.snap").isChecked()); });
    on("tool.snapSteps", [this] { findChild<ViewBar*>()->openSteps(); });
    on("tool.frame", [this] {
        const AxesOf axes = m_settings.axes();
        m_settings.setAxes(axes == AxesOf::World ? AxesOf::Parent : axes == AxesOf::Parent ? AxesOf::Local : AxesOf::World);
    });
    on("tool.drop", [this] { dropToFloor(*m_context); });
    on("tool.align", [this] { askAlign(); });
    on("tool.distribute", [this] { askDistribute(); });
    on("tool.array", [this] { askArray(); });
    connect(&m_settings, &ViewSettings::changed, this, &ViewportPanel::showTools);
    showTools();
}

void ViewportPanel::showTools() {
    for (const ToolRow& row : kTools) m_actions.at(row.id).setChecked(m_settings.tool() == row.tool);
    m_actions.at("tool.snap").setChecked(m_settings.snaps());
    for (const OverlayRow& row : kOverlays) m_actions.at(row.id).setChecked(m_settings.shows(row.overlay));
    for (const LookRow& row : kLooks) m_actions.at(row.id).setChecked(m_settings.look() == row.look);
}

void ViewportPanel::connectOverlays() {
    for (const OverlayRow& row : kOverlays)
        connect(&m_actions.at(row.id), &QAction::triggered, this,
                [this, overlay = row.overlay](bool on) { m_settings.show(overlay, on); });
    const auto reportRenderStyle = [this] {
        if (m_context->render) m_context->render->setLook(m_settings.look());
    };
    reportRenderStyle();
    connect(&m_settings, &ViewSettings::changed, this, reportRenderStyle);
    connect(&m_settings, &ViewSettings::changed, this, [this] {
        m_session.setContactsEnabled(m_settings.shows(kOverlayContacts));
        m_trails->setWanted(m_settings.shows(kOverlayTrails));
    });
}

/// The action pins or unpins the selection, or the run itself if nothing is selected.
void ViewportPanel::connectPinned() {
    const auto meant = [this] { return m_selection.empty() ? std::vector<std::string>{""} : m_selection.paths(); };
    connect(&m_actions.at("view.pinValues"), &QAction::triggered, this,
            [this, meant](bool pinned) { m_pinned->set(meant(), pinned); });
    const auto check = [this, meant] {
        const std::vector<std::string> paths = meant();
        m_actions.at("view.pinValues").setChecked(std::ranges::all_of(paths, [this](const auto& p) {
            return m_pinned->contains(p);
        }));
    };
    const auto repaint = [this] {
        if (!m_pinned->pins().empty()) m_current->update(); // repaints the overlay only
    };
    connect(&m_selection, &Selection::changed, this, check);
    connect(m_pinned.get(), &PinnedValues::changed, this, check);
    connect(m_pinned.get(), &PinnedValues::changed, this, [this] { m_current->update(); });
    connect(&m_session.values(), &RunValues::changed, this, repaint);
    // Delayed: another slot of opened() may still save the pins of the previous experiment.
    connect(&m_document, &Document::opened, this, [this] { m_pinsOfOther = true; });
    connect(&m_document, &Document::changed, this, [this](const ChangeSet& changes) { // objects may have been renamed
        if (std::exchange(m_pinsOfOther, false)) m_pinned->setPins({}), m_pinsIn = nullptr;
        const auto now = m_document.isOpen() && !m_document.loaded()->diagnostics.hasErrors() ? m_document.loaded() : nullptr;
        if (!now) return; // a block whose text is being typed may be back soon
        const auto before = std::exchange(m_pinsIn, now);
        if (before && before == changes.before() && now == changes.after() && !changes.changesObjects()) return;
        m_pinned->follow([&](const std::string& path) { return pathAfterEdit(before ? *before : *now, *now, path); });
    });
}

void ViewportPanel::lookThrough(const std::string& path) {
    const auto cameras = m_world->camerasOf(path);
    if (!cameras.empty()) m_current->camera().lookThrough(cameras.front()->path);
}

/// Repeated calls cycle through the cameras of the selection, or through all if the selection has none.
void ViewportPanel::lookThroughSelectedCamera() {
    std::vector<const CameraModel*> cameras = m_world->camerasOf(m_selection.current());
    if (cameras.empty())
        for (const CameraModel& camera : m_world->cameras()) cameras.push_back(&camera);
    if (cameras.empty()) {
        Q_EMIT m_document.refused(tr("No robot here has a camera."));
        return;
    }
    const auto at = std::ranges::find(cameras, m_current->camera().through());
    m_current->camera().lookThrough((at == cameras.end() || at + 1 == cameras.end() ? cameras.front() : *(at + 1))->path);
}

void ViewportPanel::askAlign() {
    QMenu menu(this);
    menu.setObjectName(QStringLiteral("alignMenu"));
    const std::pair<AlignTo, QString> places[] = {
        {AlignTo::Low, tr("lowest")}, {AlignTo::Middle, tr("middles")}, {AlignTo::High, tr("highest")}};
    for (int axis = 0; axis < 3; ++axis) {
        menu.addSeparator();
        for (const auto& [to, name] : places)
            connect(menu.addAction(tr("Along %1: %2").arg(axisName(axis), name)), &QAction::triggered, this,
                    [this, axis, to = to] { alignSelected(*m_context, axis, to); });
    }
    menu.exec(QCursor::pos());
}

void ViewportPanel::askDistribute() {
    QMenu menu(this);
    menu.setObjectName(QStringLiteral("distributeMenu"));
    for (int axis = 0; axis < 3; ++axis)
        connect(menu.addAction(tr("Along %1").arg(axisName(axis))), &QAction::triggered, this,
                [this, axis] { distributeSelected(*m_context, axis); });
    menu.exec(QCursor::pos());
}

void ViewportPanel::askArray() {
    if (!m_document.isOpen()) return;
    if (m_selection.empty()) {
        Q_EMIT m_document.refused(tr("Select what to copy first."));
        return;
    }
    Vec3 spacing = Vec3::Constant(0.5);
    const auto objects = m_world->objectsOf(m_selection.current());
    if (!objects.empty()) {
        const Bounds box = m_world->boundsOf(objects.front());
        // 1.5 times the size of the object, rounded.
        if (!box.empty()) spacing = (10 * 1.5 * box.size()).array().ceil() / 10;
    }
    ArrayDialog dialog(spacing, int(m_selection.paths().size()), gridRefusal(*m_context), gridIsTurned(*m_context), this);
    if (dialog.exec() == QDialog::Accepted) copyInRows(*m_context, dialog.copy());
}

void ViewportPanel::showMenu(View& view, const QPointF& at) {
    // The menu applies to the clicked object, unless that is part of the selection.
    const std::vector<std::string> chain = pickChain(*m_world, m_world->hitsAlong(view.camera().rayAt(at)));
    const bool selected =
        std::any_of(chain.begin(), chain.end(), [this](const std::string& path) { return m_selection.contains(path); });
    if (!chain.empty() && !chain.front().empty() && !selected) m_selection.select(chain.front());
    QMenu menu(this);
    menu.setObjectName(QStringLiteral("viewMenu"));
    if (!m_selection.empty()) {
        for (const char* id : {"edit.cut", "edit.copy", "edit.paste", "edit.duplicate", "edit.group", "edit.delete"})
            menu.addAction(&m_actions.at(id));
        menu.addSeparator();
        for (const char* id : {"tool.drop", "tool.align", "tool.distribute", "tool.array"}) menu.addAction(&m_actions.at(id));
        menu.addSeparator();
    } else {
        menu.addAction(&m_actions.at("edit.paste"));
        menu.addSeparator();
    }
    for (const char* id : {"view.frame", "view.frameAll"}) menu.addAction(&m_actions.at(id));
    const std::vector<const CameraModel*> cameras = m_world->camerasOf(m_selection.current());
    for (std::size_t i = 0; i < cameras.size() && i < kMaxCameras; ++i)
        connect(menu.addAction(tr("Look Through %1").arg(QString::fromStdString(cameras[i]->path))), &QAction::triggered, &view,
                [&view, path = cameras[i]->path] { view.camera().lookThrough(path); });
    menu.addAction(&m_actions.at("view.pinValues"));
    menu.addAction(&m_actions.at("view.savePicture"));
    menu.exec(view.mapToGlobal(at.toPoint()));
}

} // namespace trundle
