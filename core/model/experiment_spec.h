#pragma once
// What a text means, once resolved: typed, immutable, in SI units and radians, complete (defaults filled in).

#include <memory>
#include <optional>
#include <string>
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
    std::string texturePath;               ///< the picture found, or empty
    std::shared_ptr<const Raster> picture; ///< its pixels; of one that is missing or broken, a glaring stand-in
    std::string textureMap = "auto";       ///< auto planar box cylinder sphere
    double textureScale = 1, shininess = 0, opacity = 1;
    std::array<double, 3> emission{0, 0, 0};
    SourceRange range;
};

struct SurfaceSpec {
    std::string name;
    double friction = 0.5, restitution = 0;
    double rollingFriction = 0; ///< m
    double softness = 0;        ///< m/N
    SourceRange range;          ///< the whole block
    SourceRange nameRange;      ///< where a message about it points
};

struct AntennaSpec {
    std::string name;
    std::shared_ptr<const AntennaPattern> pattern;
    SourceRange range; ///< the whole block
};

/// A RobotConfig with one set of Param values and overrides applied. Instances that are equal share it.
struct RobotConfigSpec {
    std::string name;
    std::vector<BodySpec> bodies; ///< the first carries the robot's pose
    std::vector<JointSpec> joints;
    std::vector<ComponentSpec> devices; ///< in text order
    bool selfCollision = false;
    SourceRange range;
};

struct RobotSpec {
    std::string name;
    Pose pose; ///< of the config frame in the world at t = 0
    std::shared_ptr<const RobotConfigSpec> config;
    std::optional<ComponentSpec> controller; ///< with UpdatePeriod, Isolation, Budget among its values
    SourceRange range;                       ///< the whole block
    SourceRange nameRange; ///< where a message about the robot points; of a member, the Grid's or Scatter's name
    std::vector<SignalDescription> published; ///< by the controller, as its kind describes them
};

struct StaticSpec {
    std::string name, configName;
    Pose pose;
    std::shared_ptr<const std::vector<GeomSpec>> geoms;
    SourceRange range;     ///< the whole block
    SourceRange nameRange; ///< where a message about it points
};

enum class SolverChoice { Auto, Exact, Quick };

struct SettingsSpec {
    double tick = 0.01;  ///< s
    double duration = 0; ///< s, 0 = until stopped
    std::uint64_t seed = 1;
    Vec3 gravity{0, 0, -9.81};
    SolverChoice solver = SolverChoice::Auto;
    SourceRange solverRange; ///< of its value; unknown where the text says nothing
    int iterations = 20;
    double errorReduction = 0.8; ///< of joints, in a tick
    std::string isolation = "none", title, description;
};

struct ModuleSpec {
    std::string written; ///< as in the text
    std::string library; ///< absolute path found; empty when it was not
    SourceRange range;   ///< of the path
};

struct ExperimentSpec {
    SettingsSpec settings;
    std::vector<MaterialSpec> materials; ///< [0] is the built-in default
    std::vector<SurfaceSpec> surfaces;   ///< [0] is the built-in default
    std::vector<RobotSpec> robots;       ///< in text order, Grid and Scatter members in place
    std::vector<StaticSpec> statics;
    std::vector<AntennaSpec> antennas;
    MediumSettings medium; ///< ideal where the text has none
    std::vector<ComponentSpec> logs;
    std::vector<ComponentSpec> looks; ///< lights, sky and views
    std::vector<ModuleSpec> modules;
};

/// The pattern of that name, or the model of that name with its defaults; nullptr where there is neither.
[[nodiscard]] std::shared_ptr<const AntennaPattern> antennaNamed(const ExperimentSpec& experiment, const std::string& name);

} // namespace trundle
