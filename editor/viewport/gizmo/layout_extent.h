#pragma once
// The extent of a whole Grid or Scatter, and the value that sets it: Spacing, or Area.

#include <array>
#include <functional>
#include <optional>
#include <string>

#include "editor/viewport/gizmo/gizmo.h"
#include "project/objects/object_location.h"

namespace trundle {

class LayoutExtent {
public:
    /// The text of a property's value as written in the block; empty if it is not written there.
    using TextOf = std::function<std::string(const std::string& key)>;
    /// nullopt unless the location is a Scatter, or a Grid with several members and Spacing. Values as in the load.
    [[nodiscard]] static std::optional<LayoutExtent> of(const LoadedProject& loaded, const ObjectLocation& place,
                                                        const TextOf& textOf);

    [[nodiscard]] const Pose& axes() const { return m_pose; } ///< Pos and HPR, in the world
    [[nodiscard]] Vec3 centre() const { return m_pose * m_centre; }
    /// m, half the distance between the outer members' origins, or half the Area; 0: it cannot be changed along that axis.
    [[nodiscard]] const Vec3& half() const { return m_half; }
    [[nodiscard]] std::array<SizeName, 3> sizeNames() const;

    struct Change {
        std::string key, text;     ///< of the property to set
        Vec3 shift = Vec3::Zero(); ///< m, of Pos along the layout's own axes
    };
    /// Half the extent grown by `growth` (m): at both sides for side 0, otherwise at that side alone. `fineness`: m, of the value.
    [[nodiscard]] Change grown(const Vec3& growth, int side, double fineness) const;

private:
    Pose m_pose;
    Vec3 m_centre = Vec3::Zero(), m_half = Vec3::Zero();
    std::array<int, 2> m_gaps{};           ///< Grid: between neighbours, along x and y
    std::vector<double> m_spacing, m_area; ///< one of them is empty
    std::string m_text;
};

} // namespace trundle
