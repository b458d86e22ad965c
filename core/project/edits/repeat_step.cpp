#include "project/edits/repeat_step.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/config_blocks.h"
#include "model/dotted_path.h"
#include "model/resolve/footprint.h"
#include "project/edits/duplicate_offset.h"
#include "project/edits/template_position.h"
#include "project/objects/part_values.h"

namespace trundle {
namespace {

constexpr double kWithoutShape = 0.1, kFarthest = 100; ///< m
constexpr int kMaxMembers = 100;                       ///< of a Repeat that are looked at
constexpr int kMaxNested = 16;                         ///< Parts in Parts, bodies that count from bodies

/// The extent along y (m) of blocks of a config.
class Width {
public:
    Width(const LoadedProject& loaded, const std::vector<std::string>& paths) : m_loaded(loaded), m_paths(paths) {
        for (const std::string& path : paths) add(path, {poseOfIn(path, 0), Vec3::Ones()}, 0);
    }
    [[nodiscard]] double value() const { return m_high > m_low ? m_high - m_low : 0; }

private:
    /// The pose of what a block counts from if that is one of the blocks.
    [[nodiscard]] Pose poseOfIn(const std::string& path, int depth) const {
        const auto place = placeOf(m_loaded, path);
        const auto in = place && place->part ? valueAt(m_loaded, *place, "In") : std::nullopt;
        if (!in || in->texts.empty() || depth > kMaxNested) return {};
        const std::string other = pathInside(withoutLastWord(path), in->texts[0]);
        const auto there = placeOf(m_loaded, other);
        const bool isChosen = there && there->part && std::ranges::count(m_paths, other) > 0;
        return isChosen ? poseOfIn(other, depth + 1) * poseAt(m_loaded, *there) : Pose();
    }

    void add(const std::string& path, const DescribedFrame& frame, int depth) {
        const auto place = placeOf(m_loaded, path);
        if (!place || !place->part || depth > kMaxNested) return;
        const Part& part = *place->part;
        if (part.is(Role::Geom)) return addGeom(*place, frame);
        const auto number = [&](const char* key) {
            const auto value = valueAt(m_loaded, *place, key);
            return value && !value->numbers.empty() ? value->numbers[0] : 0.0;
        };
        DescribedFrame inner = frame;
        inner.pose = frame.pose * frame.mirrored(poseAt(m_loaded, *place));
        if (part.kind && part.kind->name == "Ring") { // as if it had members at both sides
            for (const double side : {-1.0, 1.0})
                addBlocks(part, path, {inner.pose * Pose{Vec3(0, side * number("Radius"), 0), Quat::Identity()}, inner.signs},
                          depth);
            return;
        }
        if (part.isRepeat() && !isMember(*place, part)) {
            for (int i = 0; i < std::min<double>(number("Count"), kMaxMembers); ++i)
                add(path + "_" + std::to_string(i), frame, depth + 1);
            return;
        }
        if (part.isPartUse()) {
            const auto mirror = valueAt(m_loaded, *place, "Mirror");
            const std::string axis = mirror && !mirror->texts.empty() ? mirror->texts[0] : std::string();
            if (axis == "x" || axis == "y" || axis == "z") inner.signs[axis[0] - 'x'] *= -1;
        }
        addBlocks(part, path, inner, depth);
    }
    static bool isMember(const ObjectLocation& place, const Part& repeat) { return place.memberOf(repeat).has_value(); }
    void addBlocks(const Part& part, const std::string& path, const DescribedFrame& frame, int depth) {
        for (const Part* holder = part.isPartUse() ? part.config : &part; holder;
             holder = isVariant(*holder) ? holder->config : nullptr)
            for (const Part& block : holder->parts)
                if (block.is(Role::Geom) || block.is(Role::Body) || block.isPartUse() || block.isRepeat())
                    add(pathInside(path, block.name), frame, depth + 1);
    }
    void addGeom(const ObjectLocation& place, const DescribedFrame& frame) {
        std::optional<GeomSpec> geom = shapeAt(m_loaded, place);
        if (!geom) return;
        geom->pose = frame.mirrored(geom->pose);
        for (const Footprint& foot : footprintsOf(*geom, frame.pose))
            for (const auto& corner : foot.corners) {
                m_low = std::min(m_low, corner.y() - foot.grown);
                m_high = std::max(m_high, corner.y() + foot.grown);
            }
    }

    const LoadedProject& m_loaded;
    const std::vector<std::string>& m_paths;
    double m_low = std::numeric_limits<double>::infinity(), m_high = -m_low;
};

} // namespace

Vec3 repeatStep(const LoadedProject& loaded, const std::vector<std::string>& paths) {
    const auto isInConfig = [&](const std::string& path) {
        const auto place = placeOf(loaded, path);
        return place && place->part && !place->above.empty();
    };
    if (!std::ranges::all_of(paths, isInConfig)) return duplicateOffset(loaded, paths);
    const double width = Width(loaded, paths).value();
    if (width <= 0 || !(width < kFarthest)) return {0, kWithoutShape, 0};
    const double grain = width < 0.1 ? 0.01 : width < 1 ? 0.05 : 0.1; // m
    return {0, std::floor(width / grain + 1 + 1e-6) * grain, 0};
}

} // namespace trundle
