#pragma once
// Experiments with robots that only carry a camera, and objects for it to see.

#include <map>

#include "model/experiment_spec.h"
#include "render/camera_image_renderer.h"

namespace trundle {

using CameraValues = std::map<std::string, PropertyValue>;

inline PropertyValue numbers(std::vector<double> values) { return {PropertyType::Number, std::move(values), {}}; }
inline PropertyValue word(std::string value) { return {PropertyType::Choice, {}, {std::move(value)}}; }

/// A robot `name` at `pose` with a body "mount" (of these geoms) and a Camera "eye" in its origin.
inline RobotSpec cameraRobot(const std::string& name, const Pose& pose, CameraValues values, std::vector<GeomSpec> geoms = {}) {
    auto config = std::make_shared<RobotConfigSpec>();
    BodySpec body;
    body.name = "mount";
    body.geoms = std::move(geoms);
    config->bodies = {body};
    ComponentSpec camera;
    camera.kind = "Camera";
    camera.name = "eye";
    values.try_emplace("Body", PropertyValue{PropertyType::Reference, {}, {"mount"}});
    for (auto& [key, value] : values) camera.values[key] = {value, {}, Origin::Config};
    config->devices = {camera};
    RobotSpec robot;
    robot.name = name;
    robot.pose = pose;
    robot.config = config;
    return robot;
}

/// The camera image at the start poses.
inline Result<CameraImage> captureAtStart(const std::shared_ptr<const ExperimentSpec>& experiment, const std::string& camera) {
    const SignalLayout layout;
    const SignalBlock block(layout);
    return CameraImageRenderer(experiment, layout).capture(camera, block);
}

} // namespace trundle
