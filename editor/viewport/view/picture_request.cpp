#include "editor/viewport/view/picture_request.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QWidget>

#include "editor/document/selection.h"
#include "editor/viewport/context/tool_view.h"
#include "editor/viewport/context/view_settings.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/radio/radio_overlays.h"
#include "render/service.h"

namespace trundle {
namespace {

std::array<std::uint8_t, 3> bytesOf(const QColor& colour) {
    return {std::uint8_t(colour.red()), std::uint8_t(colour.green()), std::uint8_t(colour.blue())};
}

void addOverlays(PictureRequest& r, const ViewContext& context, bool soft) {
    const ViewSettings& settings = context.settings;
    r.mask = kMaskRobots | kMaskStatics | kMaskFloor | kMaskSky | kMaskGhosts;
    r.floorLines = settings.shows(kOverlayGrid);
    if (r.floorLines) r.mask |= kMaskGuide;
    if (settings.shows(kOverlayCollision)) r.mask |= kMaskCollision;
    if (context.radios && (context.radios->inScene().shapes || context.radios->inScene().floor)) {
        r.mask |= kMaskOverlay;
        r.overlay = context.radios->inScene();
    }
    r.wireframe = settings.shows(kOverlayWireframe);
    if (settings.shows(kOverlayShadows) && !r.wireframe) r.mask |= soft ? kMaskSoftShadows : kMaskShadows;
}

void addMarks(PictureRequest& r, const ToolView& view) {
    const ViewportScene& world = view.context().world;
    const Selection& selection = view.context().selection;
    const std::string& hovered = view.hints().hovered();
    for (const std::string& path : selection.paths())
        for (const ObjectRef& object : world.objectsOf(path)) r.marks.selected.push_back(world.objects()->pathOf(object, '/'));
    if (!hovered.empty() && !selection.contains(hovered))
        for (const ObjectRef& object : world.objectsOf(hovered)) r.marks.hovered.push_back(world.objects()->pathOf(object, '/'));
    r.outline.selected = bytesOf(ToolView::outlineColour());
    r.outline.hovered = {255, 255, 255};
}

} // namespace

PictureRequest pictureRequest(const ToolView& view, bool fine, bool software) {
    PictureRequest r;
    const QWidget& widget = view.widget();
    const ViewportScene& world = view.context().world;
    // The image size is limited; beyond it one image pixel covers several screen pixels.
    const double scale =
        std::min(widget.devicePixelRatioF(), kMaxPixels / double(std::max({1, widget.width(), widget.height()})));
    const DraggedObject& dragged = world.dragged();
    r.scene = dragged.isDrawn() ? dragged.scene() : world.scene();
    r.view = view.camera().view();
    r.width = std::uint32_t(std::clamp(int(std::lround(widget.width() * scale)), 1, int(kMaxPixels)));
    r.height = std::uint32_t(std::clamp(int(std::lround(widget.height() * scale)), 1, int(kMaxPixels)));
    r.poses = dragged.isDrawn() ? dragged.posesWith(*world.poses()) : world.poses();
    r.samples = fine || !software ? 4 : 1;
    r.yields = fine;
    addOverlays(r, view.context(), fine || !software);
    r.hidden = world.hiddenInScene();
    if (const CameraModel* camera = view.camera().through(); camera && !camera->seesSelf) r.hidden.push_back(camera->robot);
    addMarks(r, view);
    r.outline.width = float(1.6 * scale);
    return r;
}

PictureRequest stillRequest(const ToolView& view, std::uint32_t width, std::uint32_t height) {
    PictureRequest r = pictureRequest(view, true, true);
    r.view = view.camera().viewFor(width, height);
    r.width = width;
    r.height = height;
    r.marks = {};
    r.yields = false;
    return r;
}

} // namespace trundle
