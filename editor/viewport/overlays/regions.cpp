#include "editor/viewport/overlays/regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <QPainter>

#include "editor/viewport/context/label.h"
#include "editor/viewport/context/tool_view.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/overlays/selected_names.h"
#include "model/robot_path.h"
#include "scene/shapes/extents.h"

namespace trundle {
namespace {

constexpr std::size_t kMostRegions = 300;
constexpr double kReach = 5; // pixels, of a click from an edge
const QColor kOpen(64, 190, 170);

/// Corner k is at the sides of the box that its bits say: x, y, z.
constexpr int kFaces[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};

/// Nothing if a corner is behind the camera.
std::optional<std::array<QPointF, 8>> cornersOf(const ToolView& view, const RegionSpec& region) {
    std::array<QPointF, 8> corners;
    for (int k = 0; k < 8; ++k) {
        const Vec3 side(k & 1 ? 0.5 : -0.5, k & 2 ? 0.5 : -0.5, k & 4 ? 0.5 : -0.5);
        const auto at = view.shownPixelOf(region.pose * Vec3(side.cwiseProduct(region.size)));
        if (!at) return std::nullopt;
        corners[std::size_t(k)] = *at;
    }
    return corners;
}

double distanceToLine(const QPointF& at, const QPointF& from, const QPointF& to) { // pixels; between its ends
    const QPointF along = to - from, away = at - from;
    const double length = QPointF::dotProduct(along, along);
    const double share = length > 0 ? std::clamp(QPointF::dotProduct(away, along) / length, 0.0, 1.0) : 0;
    const QPointF off = away - share * along;
    return std::hypot(off.x(), off.y());
}

} // namespace

std::string regionAt(const ToolView& view, const QPointF& at) {
    std::string nearest;
    double least = kReach;
    const auto& regions = view.context().world.objects()->experiment().regions;
    for (std::size_t i = 0; i < regions.size() && i < kMostRegions; ++i) {
        const auto corners = cornersOf(view, regions[i]);
        for (std::size_t from = 0; corners && from < 8; ++from)
            for (const std::size_t to : {from | 1U, from | 2U, from | 4U}) {
                const double distance = from == to ? least : distanceToLine(at, (*corners)[from], (*corners)[to]);
                if (distance < least) least = distance, nearest = regions[i].name;
            }
    }
    return nearest;
}

Bounds boundsOfRegions(const ExperimentSpec& experiment, const std::string& path) {
    Bounds all;
    const auto isRegion = [&](std::string_view name) {
        return std::ranges::find(experiment.regions, name, &RegionSpec::name) != experiment.regions.end();
    };
    for (const RegionSpec& region : experiment.regions) {
        if (!isNamedBy(region.name, path, isRegion)) continue;
        GeomSpec box;
        box.shape = GeomShape::Box;
        box.size = region.size;
        all.add(boundsOf(box, region.pose));
    }
    return all;
}

void paintRegions(QPainter& painter, const ToolView& view) {
    std::vector<std::pair<QPointF, QString>> names;
    const auto& regions = view.context().world.objects()->experiment().regions;
    for (std::size_t i = 0; i < regions.size() && i < kMostRegions; ++i) {
        const auto corners = cornersOf(view, regions[i]);
        if (!corners) continue;
        QColor colour = isSelected(view.context(), regions[i].name) ? ToolView::outlineColour() : kOpen;
        painter.setPen(QPen(colour, 1.4, Qt::DashLine));
        QColor fill = colour;
        fill.setAlpha(22);
        painter.setBrush(fill);
        QPointF top = corners->front();
        for (const auto& face : kFaces) {
            QPolygonF polygon;
            for (const int corner : face) polygon << (*corners)[std::size_t(corner)];
            painter.drawPolygon(polygon);
        }
        for (const QPointF& corner : *corners)
            if (corner.y() < top.y()) top = corner;
        names.emplace_back(top, QString::fromStdString(regions[i].name));
    }
    for (const auto& [corner, name] : names) paintLabel(painter, corner - QPointF(0, 14), name); // over all boxes
}

} // namespace trundle
