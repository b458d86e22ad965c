#pragma once
// The individual model checks. Private to core/check.

#include <numbers>
#include <stop_token>

#include "base/diagnostic.h"
#include "check/start_scene.h"
#include "project/loading/project.h"

namespace trundle {

inline constexpr double kDegree = std::numbers::pi / 180;

/// Reports bodies that no joint holds, two joints for the same bodies, closed loops, and mass properties that do not fit the shapes.
void checkBodies(const LoadedProject& loaded, Diagnostics& diagnostics);
/// Reports joints at the top level whose point is far from a body that they join, or that close a loop.
void checkLinks(const ExperimentSpec& experiment, Diagnostics& diagnostics);
/// Reports Gears whose ratios contradict each other.
void checkGears(const ExperimentSpec& experiment, Diagnostics& diagnostics);
void checkMasses(const ExperimentSpec& experiment, Diagnostics& diagnostics);
/// Reports springs of joints and surfaces that swing faster than the tick can follow.
void checkSprings(const ExperimentSpec& experiment, Diagnostics& diagnostics);
/// Reports robots without a device that their controller needs; a run would refuse them.
void checkNeeds(const LoadedProject& loaded, Diagnostics& diagnostics);
/// Reports motors that share a joint or differ between the sides, and encoders on the wrong joint.
void checkMotors(const RobotConfigSpec& config, Diagnostics& diagnostics);
/// Reports servos and linear motors too weak for the weight of what they carry.
void checkHolds(const ExperimentSpec& experiment, Diagnostics& diagnostics);
/// Reports drives whose values disagree with their wheels, or whose wheels turn the wrong way.
void checkDrives(const LoadedProject& loaded, Diagnostics& diagnostics);
/// Reports robots that start inside something else or below a floor.
void checkStart(const LoadedProject& loaded, const StartScene& scene, Diagnostics& diagnostics);
/// Reports robots that start unsupported in the air.
void checkSupport(const LoadedProject& loaded, const StartScene& scene, Diagnostics& diagnostics, const std::stop_token& stop);

/// Reports gravity that points out of the floor.
[[nodiscard]] bool reportedGravity(const LoadedProject& loaded, Diagnostics& diagnostics);
/// Reports wheels that stay in the air.
void checkGround(const StartScene& scene, Diagnostics& diagnostics);
/// Reports motors too weak for the ramps or oddly fast, and scenery thinner than the way of one tick. `up`: as StartScene::up().
void checkSpeeds(const LoadedProject& loaded, const Vec3& up, Diagnostics& diagnostics);
/// Reports definitions of a file that nothing uses.
void checkUnused(const LoadedProject& loaded, FileId file, Diagnostics& diagnostics);

/// Whether all shapes of both bodies are alike, collide, and are in one place.
[[nodiscard]] bool isTwin(const BodySpec& a, const BodySpec& b);

/// A length (m) with three significant digits and a suitable unit: "3.5 m", "12 mm".
[[nodiscard]] std::string lengthText(double metres);
/// A number with three significant digits.
[[nodiscard]] std::string figureText(double value);

} // namespace trundle
