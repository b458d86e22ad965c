#pragma once
// Field tables of the blocks inside configs: bodies, geoms, joints.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <trundle/describe.h>

namespace trundle {

struct BodyFields {
    std::array<double, 3> pos{0, 0, 0}, hpr{0, 0, 0};
    std::optional<std::string> in;
    std::optional<double> mass;
    std::optional<std::array<double, 3>> centreOfMass;
    std::optional<std::vector<double>> inertia; ///< three or six numbers
    static void describe(Describe<BodyFields>& d);
};

/// Fields of all geoms.
struct GeomFields {
    std::array<double, 3> pos{0, 0, 0}, hpr{0, 0, 0};
    std::optional<std::string> material, surface;
    bool collide = true, visible = true;
};
/// Fields of solid geoms.
struct SolidFields : GeomFields {
    std::optional<double> mass, density;
};

struct BoxFields : SolidFields {
    std::array<double, 3> size{};
    static void describe(Describe<BoxFields>& d);
};
struct SphereFields : SolidFields {
    double radius = 0;
    static void describe(Describe<SphereFields>& d);
};
struct CylinderFields : SolidFields {
    double radius = 0, length = 0;
    static void describe(Describe<CylinderFields>& d);
};
struct CapsuleFields : SolidFields {
    double radius = 0, length = 0;
    static void describe(Describe<CapsuleFields>& d);
};
struct ConvexFields : SolidFields {
    std::string file;
    std::vector<double> scale{1};
    static void describe(Describe<ConvexFields>& d);
};
struct MeshFields : SolidFields {
    std::string file;
    std::vector<double> scale{1};
    std::optional<std::string> shape;
    static void describe(Describe<MeshFields>& d);
};
struct PlaneFields : GeomFields {
    static void describe(Describe<PlaneFields>& d);
};
struct HeightfieldFields : GeomFields {
    std::string file;
    std::array<double, 3> size{};
    static void describe(Describe<HeightfieldFields>& d);
};

/// Fields of all joints; each kind describes the ones that apply to it.
struct JointFields {
    std::string parent, child;
    std::optional<std::array<double, 3>> anchor;
    std::array<double, 3> axis{0, 0, 1}, axis2{1, 0, 0};
    std::optional<double> lowStop, highStop, lowStop2, highStop2, stiffness2, damping2, swingStop;
    double damping = 0, friction = 0, stiffness = 0, travel = 0, rest = 0;
};
struct HingeFields : JointFields {
    static void describe(Describe<HingeFields>& d);
};
struct SliderFields : JointFields {
    static void describe(Describe<SliderFields>& d);
};
struct BallFields : JointFields {
    static void describe(Describe<BallFields>& d);
};
struct UniversalFields : JointFields {
    static void describe(Describe<UniversalFields>& d);
};
struct FixedFields : JointFields {
    static void describe(Describe<FixedFields>& d);
};
struct SuspensionFields : JointFields {
    SuspensionFields() { axis2 = {0, 1, 0}; }
    static void describe(Describe<SuspensionFields>& d);
};

struct SpringFields {
    std::string parent, child;
    std::optional<std::array<double, 3>> anchor, anchor2;
    std::optional<double> length;
    double stiffness = 0, damping = 0;
    static void describe(Describe<SpringFields>& d);
};
struct GearFields {
    std::string joint, other;
    double ratio = 1;
    static void describe(Describe<GearFields>& d);
};

} // namespace trundle
