#pragma once
// Mirror images of bodies, geoms, joints and devices, as a Part with Mirror has them. Private to core/model.

#include "model/kinds/world_fields.h"
#include "model/resolve/resolve_context.h"

namespace trundle {

/// Where a Part puts what its config describes: first the mirror image, then the pose, in the frame of what holds the Part.
class PartPlacement {
public:
    PartPlacement() = default; ///< as described
    explicit PartPlacement(const PartFields& fields);
    explicit PartPlacement(const Pose& pose) : m_given(pose), m_pose(pose) {}

    [[nodiscard]] bool isMirrored() const { return m_axis >= 0; }
    /// Whether a base of this kind drives as it does in the mirror image: its wheels keep their sense, so those of an OmniDrive no longer
    /// turn it all the same way, a car's steered wheels are behind, and the rollers of a MecanumDrive lie the other way below than above.
    [[nodiscard]] bool canPlace(std::string_view device) const {
        return !(device == "OmniDrive" && (m_axis == 0 || m_axis == 1)) && !(device == "AckermannDrive" && m_axis == 0) &&
               !(device == "MecanumDrive" && m_axis == 2);
    }

    [[nodiscard]] Pose pose(const Pose& described) const;
    /// From now on its pose is one in the frame that has this pose.
    void countFrom(const Pose& frame);
    void place(BodySpec& body) const { body.pose = pose(body.pose); }
    /// What is in a body: its geoms, and a centre of mass and inertia that are given. False, with a diagnostic, if a geom has no mirror
    /// image.
    [[nodiscard]] bool mirror(ResolveContext& context, GeomSpec& geom) const;
    void mirror(MassProperties& given) const;
    /// A geom of a StaticConfig, whose frame is that of the part.
    [[nodiscard]] bool place(ResolveContext& context, GeomSpec& geom) const;
    /// The mirror image of a joint moves as the joint does: what slides goes the mirrored way; what turns keeps its sense, so that
    /// its axis is the mirrored line in the direction nearest to the described one (at 45 degrees, that of the image), and its stops are
    /// where the mirror image has them.
    void place(JointSpec& joint) const;
    void place(SpringSpec& spring) const;
    /// Whether the mirror image of a joint has its sense reversed against the described one, so that what couples it with another
    /// joint may have to change its sign. `axis` is in the frame of what holds the Part, then in that of the part.
    [[nodiscard]] bool reverses(JointType type, Vec3& axis) const;
    /// Pos and HPR of a device are those of its mirror image in the body. In a body from outside of the part they count from the
    /// part's Pos and HPR on, which count in that body. With Mirror = y, values of Left... and Right... are exchanged, with Mirror = x those
    /// of Front... and Back....
    void place(ComponentSpec& device, bool isOnOwnBody) const;

private:
    [[nodiscard]] Vec3 mirrored(const Vec3& vector) const;
    [[nodiscard]] Quat mirrored(const Quat& rotation) const;
    [[nodiscard]] Vec3 mirroredAxis(const Vec3& axis, bool& isReversed) const;
    [[nodiscard]] Vec3 mirroredHpr(const Vec3& hpr) const;

    int m_axis = -1; ///< that is mirrored: 0 x, 1 y, 2 z
    Pose m_given;    ///< its Pos and HPR
    Pose m_pose;     ///< the same in the frame of what holds the Part, from where they count by In
};

} // namespace trundle
