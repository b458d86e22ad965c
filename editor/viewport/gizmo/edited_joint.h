#pragma once
// The joint that is selected, and the edits of its anchor, axes and stops.

#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "editor/document/document.h"
#include "model/joint_spec.h"
#include "project/objects/part_values.h"

namespace trundle {

struct ViewContext;

/// A stop of a joint: of its (first) axis or of Axis2.
struct JointStop {
    bool isHigh = false, isSecond = false;
    bool operator==(const JointStop&) const = default;
};

class EditedJoint {
public:
    /// The joint that the selection refers to: a joint, or a device with a Joint; of all members of a Repeat the first one's. Nothing if several objects are selected, and during a run.
    [[nodiscard]] static std::optional<EditedJoint> selected(const ViewContext& context);

    [[nodiscard]] const std::string& path() const { return m_path; }
    /// As resolved, in the frame C of its config, moved with its parent; of a joint between robots in the world.
    [[nodiscard]] const JointSpec& spec() const { return m_spec; }
    [[nodiscard]] const Pose& X_WC() const { return m_X_WC; }
    /// Points of its two bodies that its anchor snaps to, in C.
    [[nodiscard]] const std::vector<Vec3>& points() const { return m_points; }
    /// A direction to the child at a right angle to an axis, in C: that of the angle 0.
    [[nodiscard]] Vec3 zeroDirection(const Vec3& axis) const;
    [[nodiscard]] bool canMoveAnchor() const;
    [[nodiscard]] bool hasStops(bool second) const;
    /// Unit vector in C.
    [[nodiscard]] const Vec3& axis(bool second) const { return second ? m_spec.axis2 : m_spec.axis; }
    [[nodiscard]] bool turns() const { return m_spec.type != JointType::Slider; } ///< stops are angles
    [[nodiscard]] bool hasSecondAxis() const {
        return m_spec.type == JointType::Universal || m_spec.type == JointType::Suspension;
    }
    [[nodiscard]] std::optional<double> stop(const JointStop& which) const;

    /// Each writes the value at the joint; calls with one merge key are one entry of the history. Values in C, m and rad; `fine`: m or degrees.
    Status setAnchor(Document& document, const Vec3& anchor, double fine, const std::string& mergeKey) const;
    /// The axes of a Universal stay at a right angle.
    Status setAxis(Document& document, const Vec3& axis, bool second, const std::string& mergeKey);
    Status setStop(Document& document, const JointStop& which, double value, double fine, const std::string& mergeKey) const;
    Status setSwing(Document& document, double value, double fine, const std::string& mergeKey) const;  ///< of a Ball
    Status setTravel(Document& document, double value, double fine, const std::string& mergeKey) const; ///< of a Suspension

private:
    EditedJoint() = default;
    void find(const ViewContext& context, const std::string& path, bool asInText);
    void findLink(const ViewContext& context, const std::string& path);
    void addPoints(const BodySpec& body, const Pose& X_CB);
    [[nodiscard]] Vec3 describedPoint(const Vec3& point) const;
    [[nodiscard]] Vec3 describedAxis(const Vec3& axis) const;
    [[nodiscard]] bool isReversed(const Vec3& axis) const;
    [[nodiscard]] std::string axisText(const Vec3& axis) const;

    std::string m_path, m_placePath; ///< m_placePath: of a Repeat's members, the first one's
    JointSpec m_spec;
    Pose m_X_WC;
    DescribedFrame m_described;
    std::vector<Vec3> m_points;
    Vec3 m_childCentre = Vec3::Zero();
    bool m_axis2Edited = false;
    std::string m_anchorText, m_lowText, m_highText, m_swingText,
        m_travelText; ///< as written where they are edited; empty: not written
};

} // namespace trundle
