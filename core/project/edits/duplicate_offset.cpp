#include "project/edits/duplicate_offset.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/resolve/footprint.h"
#include "project/edits/plan_targets.h"

namespace trundle {
namespace {

constexpr double kStep = 0.1, kFarthest = 100; ///< m

/// The extent of objects along y, in metres.
struct Span {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    void add(double from, double to) { low = std::min(low, from), high = std::max(high, to); }
};

/// Of the robots and scenery that these blocks describe: those of a Repeat, Ring, Grid or Scatter are all its members.
Span spanOf(const LoadedProject& loaded, const std::vector<std::string>& paths) {
    Span span;
    std::vector<SourceRange> blocks;
    for (const std::string& path : paths)
        if (const auto place = placeOf(loaded, path); place && place->part) blocks.push_back(place->part->range);
    const auto chosen = [&](const SourceRange& block) {
        return std::ranges::any_of(blocks, [&](const SourceRange& outer) { return isWithin(block, outer); });
    };
    for (const RobotSpec& robot : loaded.experiment->robots) {
        if (!chosen(robot.range) || !robot.config) continue;
        const double y = robot.pose.position.y(), radius = discOf(*robot.config).radius;
        span.add(y - radius, y + radius);
    }
    for (const StaticSpec& scenery : loaded.experiment->statics) {
        if (!chosen(scenery.range) || !scenery.geoms) continue;
        for (const GeomSpec& geom : *scenery.geoms)
            for (const Footprint& foot : footprintsOf(geom, scenery.pose))
                for (const auto& corner : foot.corners) span.add(corner.y() - foot.grown, corner.y() + foot.grown);
    }
    return span;
}

} // namespace

Vec3 duplicateOffset(const LoadedProject& loaded, const std::vector<std::string>& paths) {
    const Span span = spanOf(loaded, paths);
    const double width = span.high > span.low ? span.high - span.low : 0;
    if (!(width < kFarthest)) return {0, kStep, 0};
    return {0, std::floor(width / kStep + 1 + 1e-6) * kStep, 0};
}

} // namespace trundle
