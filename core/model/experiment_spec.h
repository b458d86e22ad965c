#pragma once
// The resolved experiment: typed, immutable, SI units and radians, defaults filled in.

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/raster.h"
#include "model/body_spec.h"
#include "model/component_spec.h"
#include "model/joint_spec.h"
#include "radio/radio_settings.h"

namespace trundle {

struct MaterialSpec {
    std::string name;
    std::array<double, 3> colour{0.8, 0.8, 0.8};
    std::string texture;                   ///< as written
    std::string texturePath;               ///< path of the file found, or empty
    std::shared_ptr<const Raster> picture; ///< its pixels; a placeholder if it is missing or damaged
    std::string textureMap = "auto";       ///< auto planar box cylinder sphere
    double textureScale = 1, shininess = 0, opacity = 1;
    std::array<double, 3> emission{0, 0, 0};
    SourceRange range;
};

struct SurfaceSpec {
    std::string name;
    double friction = 0.5, restitution = 0;
    double rollingFriction = 0;      ///< m
    double softness = 0;             ///< m/N
    SourceRange range;               ///< the whole block
    SourceRange nameRange;           ///< for diagnostics about the surface
    std::optional<double> friction2; ///< across the geom's direction, `friction` being along it; none: the same in all directions
    double frictionHeading = 0;      ///< rad, from the geom's direction to that of `friction`, about the normal towards the geom
};

struct AntennaSpec {
    std::string name;
    std::shared_ptr<const AntennaPattern> pattern;
    SourceRange range; ///< the whole block
};

/// A RobotConfig, or the bodies, joints and devices of a StaticConfig, with one set of Param values and overrides applied. Equal
/// instances share it.
struct RobotConfigSpec {
    std::string name;
    std::vector<BodySpec> bodies; ///< the first one has the robot's pose
    std::vector<JointSpec> joints;
    std::vector<SpringSpec> springs;
    std::vector<GearSpec> gears;
    std::vector<ComponentSpec> devices; ///< in text order
    bool selfCollision = false;
    SourceRange range;
    std::vector<std::pair<int, int>> noContact; ///< pairs of its bodies that do not touch each other, ascending
};

/// A controller of a robot: a component that includes UpdatePeriod, Isolation and Budget.
struct ControllerSpec : ComponentSpec {
    std::vector<SignalDescription> published; ///< signals published by it, from its kind
};

struct RobotSpec {
    std::string name;
    Pose pose; ///< of the config frame in the world frame at t = 0
    std::shared_ptr<const RobotConfigSpec> config;
    std::vector<ControllerSpec> controllers; ///< in text order; no two command the same signal
    SourceRange range;                       ///< the whole block
    SourceRange nameRange;                   ///< for diagnostics about the robot; for a member, the name of its Grid or Scatter
    /// Of what moves, senses or acts in a Static: its fixed geoms, which StaticSpec has too, and the first body is fixed. Null: a robot.
    std::shared_ptr<const std::vector<GeomSpec>> scenery;
};

/// "the controller Walker of robot0"; with its name if the robot has several.
[[nodiscard]] inline std::string controllerTitle(const RobotSpec& robot, const ControllerSpec& controller) {
    return "the controller " + controller.kind + (robot.controllers.size() > 1 ? " " + controller.name : "") + " of " + robot.name;
}

/// Name of the fixed body of a Static with bodies or devices: that of the world in the text.
inline constexpr const char* kFixedBody = "world";

struct StaticSpec {
    std::string name, configName;
    Pose pose;
    std::shared_ptr<const std::vector<GeomSpec>> geoms;
    SourceRange range;     ///< the whole block
    SourceRange nameRange; ///< for diagnostics about the static
};

enum class SolverChoice { Auto, Exact, Quick };
/// Planar is the wheeled engine with vehicles that move over x and y and turn, no more.
enum class EngineChoice { General, Wheeled, Planar, Auto };

/// As in a text.
[[nodiscard]] inline const char* nameOf(EngineChoice engine) {
    switch (engine) {
    case EngineChoice::Wheeled: return "wheeled";
    case EngineChoice::Planar: return "planar";
    case EngineChoice::Auto: return "auto";
    default: return "general";
    }
}

struct SettingsSpec {
    double tick = 0.01;  ///< s
    double duration = 0; ///< s, 0 = until stopped
    std::uint64_t seed = 1;
    Vec3 gravity{0, 0, -9.81};
    SolverChoice solver = SolverChoice::Auto;
    SourceRange solverRange; ///< of its value; unknown if it is the default
    EngineChoice engine = EngineChoice::General;
    SourceRange engineRange; ///< of its value; unknown if it is the default
    std::string whyGeneral;  ///< what the wheeled engine cannot hold, where Auto has become General
    int iterations = 20;
    int threads = 0; ///< that compute the motion; 0: as many as the machine has, where the work is worth it
    double errorReduction = 0.8; ///< error reduction parameter of joints, per tick
    std::string isolation = "none", title, description;
};

/// A box in which robots are counted; nothing touches it.
struct RegionSpec {
    std::string name;
    Pose pose;                       ///< of its middle
    Vec3 size = Vec3::Ones();        ///< full lengths, m
    std::vector<std::size_t> robots; ///< that it counts, by index, ascending
    SourceRange range, nameRange;
};

struct ModuleSpec {
    std::string written; ///< as in the text
    std::string library; ///< absolute path; empty if not found
    SourceRange range;   ///< of the path
};

struct ExperimentSpec {
    SettingsSpec settings;
    std::vector<MaterialSpec> materials; ///< [0] is the built-in default
    std::vector<SurfaceSpec> surfaces;   ///< [0] is the built-in default
    std::vector<RobotSpec> robots; ///< in text order, including the members of Grids and Scatters; then what moves in Statics
    std::vector<StaticSpec> statics;
    std::vector<AntennaSpec> antennas;
    MediumSettings medium; ///< ideal if the text defines none
    std::vector<ComponentSpec> logs;
    std::vector<ComponentSpec> looks; ///< lights, sky and views
    std::vector<ModuleSpec> modules;
    std::vector<Link<JointSpec>> joints; ///< at the top level, in text order
    std::vector<Link<SpringSpec>> springs;
    std::vector<RegionSpec> regions;
    std::vector<std::pair<std::size_t, std::size_t>> noContact; ///< pairs of robots that do not touch each other
};

/// The pattern with that name, or the antenna model with that name and default values; nullptr if there is neither.
[[nodiscard]] std::shared_ptr<const AntennaPattern> antennaNamed(const ExperimentSpec& experiment, const std::string& name);

} // namespace trundle
