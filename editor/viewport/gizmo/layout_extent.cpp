#include "editor/viewport/gizmo/layout_extent.h"

#include <algorithm>
#include <cmath>

#include "lang/number_text.h"
#include "project/objects/part_values.h"

namespace trundle {
namespace {

constexpr double kLeastExtent = 1e-3; // m, minimum of a spacing or a side of an area that a drag can reach

std::vector<double> numbersOf(const LoadedProject& loaded, const ObjectLocation& place, const char* key) {
    const std::optional<PropertyValue> value = valueAt(loaded, place, key);
    return value ? value->numbers : std::vector<double>();
}

double rounded(double value, double step) { return step * std::round(value / step); }

} // namespace

std::optional<LayoutExtent> LayoutExtent::of(const LoadedProject& loaded, const ObjectLocation& place, const TextOf& textOf) {
    if (!place.part || !place.part->is(Role::Layout) || place.member || !place.within.empty() || !place.around.empty())
        return std::nullopt;
    LayoutExtent extent;
    extent.m_pose = poseAt(loaded, place);
    if (const std::vector<double> area = numbersOf(loaded, place, "Area"); area.size() == 4) {
        extent.m_area = area;
        extent.m_centre = {(area[0] + area[2]) / 2, (area[1] + area[3]) / 2, 0};
        extent.m_half = {(area[2] - area[0]) / 2, (area[3] - area[1]) / 2, 0};
        extent.m_text = textOf("Area");
        if (extent.m_half.x() <= 0 || extent.m_half.y() <= 0) return std::nullopt;
        return extent;
    }
    extent.m_spacing = numbersOf(loaded, place, "Spacing");
    const std::vector<double> count = numbersOf(loaded, place, "Count");
    if (extent.m_spacing.empty() || count.empty()) return std::nullopt;
    extent.m_gaps = {int(count[0]) - 1, count.size() > 1 ? int(count[1]) - 1 : 0};
    for (int k = 0; k < 2; ++k)
        extent.m_half[k] = extent.m_gaps[std::size_t(k)] *
                           extent.m_spacing[std::min<std::size_t>(std::size_t(k), extent.m_spacing.size() - 1)] / 2;
    extent.m_text = textOf("Spacing");
    if (extent.m_half.isZero()) return std::nullopt; // one member, or all in one place
    return extent;
}

std::array<SizeName, 3> LayoutExtent::sizeNames() const {
    static constexpr std::array<char16_t, 2> kAxes{u'x', u'y'};
    std::array<SizeName, 3> names;
    for (std::size_t k = 0; k < 2; ++k) {
        if (!m_area.empty()) names[k] = {QStringLiteral("Area ") + kAxes[k]};
        else if (m_gaps[k] > 0) names[k] = {QStringLiteral("Spacing ") + kAxes[k], 2.0 / m_gaps[k]};
    }
    return names;
}

LayoutExtent::Change LayoutExtent::grown(const Vec3& growth, int side, double fineness) const {
    Change change;
    if (!m_area.empty()) {
        std::vector<double> area = m_area;
        for (std::size_t k = 0; k < 2; ++k) {
            const double by = std::max(2 * growth[int(k)], kLeastExtent - (m_area[k + 2] - m_area[k]));
            if (by == 0) continue;
            area[k] = side < 0 ? rounded(m_area[k] - by, fineness) : side == 0 ? rounded(m_area[k] - by / 2, fineness) : area[k];
            area[k + 2] = side > 0    ? rounded(m_area[k + 2] + by, fineness)
                          : side == 0 ? rounded(m_area[k + 2] + by / 2, fineness)
                                      : area[k + 2];
        }
        return {"Area", withNumbers(m_text, m_area, area, "m", fineness), Vec3::Zero()};
    }
    std::vector<double> before = m_spacing;
    if (before.size() == 1 && m_gaps[0] > 0 && m_gaps[1] > 0) before.push_back(before[0]); // one number for both axes
    std::vector<double> after = before;
    for (std::size_t k = 0; k < 2; ++k) {
        if (m_gaps[k] == 0 || growth[int(k)] == 0) continue;
        double& spacing = after[std::min(k, after.size() - 1)];
        const double was = spacing;
        spacing = std::max(kLeastExtent, rounded(spacing + 2 * growth[int(k)] / m_gaps[k], fineness));
        change.shift[int(k)] = 0.5 * side * m_gaps[k] * (spacing - was);
    }
    change.key = "Spacing";
    change.text = before == after ? m_text : withNumbers(m_text, before, after, "m", fineness);
    return change;
}

} // namespace trundle
