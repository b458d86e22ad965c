#pragma once
// Field tables of the top-level blocks and instances.

#include <array>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <trundle/describe.h>

namespace trundle {

using Triple = std::array<double, 3>;

struct SettingsFields {
    double tick = 0.01, duration = 0;
    double seed = 1; ///< integer, below 2^53
    Triple gravity{0, 0, -9.81};
    std::string solver = "auto", engine = "general";
    int iterations = 20, threads = 0;
    double errorReduction = 0.8;
    std::optional<std::string> isolation;
    std::string title, description;
    std::optional<std::vector<std::string>> noContact; ///< pairs of robots
    static void describe(Describe<SettingsFields>& d);
};

struct MaterialFields {
    Triple colour{0.8, 0.8, 0.8}, emission{0, 0, 0};
    std::optional<std::string> texture;
    std::string textureMap = "auto";
    double textureScale = 1, shininess = 0, opacity = 1;
    static void describe(Describe<MaterialFields>& d);
};

struct SurfaceFields {
    double friction = 0.5, restitution = 0, rollingFriction = 0, softness = 0;
    std::optional<double> friction2;
    double frictionHeading = 0; ///< rad
    static void describe(Describe<SurfaceFields>& d);
};

/// What every config may name: the config that it is a variant of.
struct VariantFields {
    std::optional<std::string> config;
};
struct RobotConfigFields : VariantFields {
    bool selfCollision = false;
    std::optional<std::vector<std::string>> noContact; ///< pairs of bodies
    static void describe(Describe<RobotConfigFields>& d);
};

struct PartConfigFields : VariantFields {
    static void describe(Describe<PartConfigFields>& d);
};
struct StaticConfigFields : VariantFields {
    static void describe(Describe<StaticConfigFields>& d);
};

/// Config and pose of an instance.
struct PoseFields {
    std::string config;
    Triple pos{0, 0, 0}, hpr{0, 0, 0}; ///< m; rad
};

struct RobotFields : PoseFields {
    static void describe(Describe<RobotFields>& d);
};
struct StaticFields : PoseFields {
    static void describe(Describe<StaticFields>& d);
};
struct PartFields : PoseFields {
    std::optional<std::string> in;
    std::string mirror = "none";
    static void describe(Describe<PartFields>& d);
};
/// Poses are those of one member.
struct RepeatFields {
    std::vector<double> count;
    std::optional<std::string> in;
    Triple pos{0, 0, 0}, hpr{0, 0, 0}; ///< m; rad
    static void describe(Describe<RepeatFields>& d);
};
/// The pose is that of the ring's centre.
struct RingFields {
    double count = 1, radius = 0;
    Triple axis{0, 0, 1}, pos{0, 0, 0}, hpr{0, 0, 0}; ///< m; rad
    std::optional<std::string> in;
    static void describe(Describe<RingFields>& d);
};
struct GridFields : PoseFields {
    std::vector<double> count, spacing;
    static void describe(Describe<GridFields>& d);
};
struct ScatterFields : PoseFields {
    double count = 1, seed = 0;
    std::array<double, 4> area{};
    std::optional<double> minDistance, heading; ///< m; rad
    static void describe(Describe<ScatterFields>& d);
};

inline constexpr std::size_t kMaxLamps = 8; ///< limit for the cost per pixel; the first ones are used

struct LightFields {
    std::string mode = "sun";
    Triple pos{0, 0, 2}, direction{0.52, 0.30, -0.80}, colour{1, 1, 1};
    double intensity = 1;
    bool shadows = true;
    static void describe(Describe<LightFields>& d);
};
struct SkyFields {
    Triple zenith{0.265, 0.48, 0.765}, horizon{0.815, 0.865, 0.905};
    double ambient = 1;
    static void describe(Describe<SkyFields>& d);
};
struct ViewFields {
    std::string mode = "fixed";
    std::optional<std::string> robot;
    Triple eye{3, -4, 3}, target{0, 0, 0};
    double fieldOfView = 50 * std::numbers::pi / 180;
    static void describe(Describe<ViewFields>& d);
};

struct RegionFields {
    Triple pos{0, 0, 0}, hpr{0, 0, 0}, size{}; ///< m; rad; m
    std::optional<std::vector<std::string>> robots;
    static void describe(Describe<RegionFields>& d);
};

/// Fields of every controller block, in addition to those of its kind.
struct ControllerFields {
    double updatePeriod = 0; ///< s
    std::optional<std::string> isolation;
    std::optional<double> budget; ///< s; given in ms
    static void describe(Describe<ControllerFields>& d);
};

} // namespace trundle
