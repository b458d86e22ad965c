#include "render/sample_experiment.h"

#include <cmath>
#include <numbers>

namespace trundle {
namespace {

GeomSpec geom(std::string name, GeomShape shape, std::uint32_t material, Vec3 at, Vec3 hpr = Vec3::Zero()) {
    GeomSpec g;
    g.name = std::move(name);
    g.shape = shape;
    g.material = material;
    g.pose = {at, rotationFromHpr(hpr)};
    return g;
}
GeomSpec box(std::string name, Vec3 size, std::uint32_t material, Vec3 at, Vec3 hpr = Vec3::Zero()) {
    GeomSpec g = geom(std::move(name), GeomShape::Box, material, at, hpr);
    g.size = size;
    return g;
}
GeomSpec round(std::string name, GeomShape shape, double radius, double length, std::uint32_t material, Vec3 at,
               Vec3 hpr = Vec3::Zero()) {
    GeomSpec g = geom(std::move(name), shape, material, at, hpr);
    g.radius = radius;
    g.length = length;
    return g;
}

std::vector<MaterialSpec> materials() {
    std::vector<MaterialSpec> all(11);
    const auto set = [&](std::size_t i, const char* name, std::array<double, 3> colour) {
        all[i].name = name, all[i].colour = colour;
    };
    set(0, "default", {0.8, 0.8, 0.8});
    set(1, "lightgrey", {0.75, 0.75, 0.75});
    set(2, "darkgrey", {0.25, 0.25, 0.25});
    set(3, "red", {0.80, 0.15, 0.12});
    set(4, "black", {0.08, 0.08, 0.08});
    set(5, "wood", {0.72, 0.53, 0.34});
    set(6, "concrete", {0.60, 0.59, 0.56});
    set(7, "blue", {0.15, 0.35, 0.70});
    set(8, "glass", {0.6, 0.8, 0.85});
    set(9, "orange", {0.90, 0.50, 0.10});
    set(10, "steel", {0.62, 0.64, 0.68});
    all[8].opacity = 0.35;
    all[8].shininess = all[10].shininess = 0.7;
    return all;
}

std::shared_ptr<const RobotConfigSpec> simpleRobot() {
    auto config = std::make_shared<RobotConfigSpec>();
    config->name = "SimpleRobot";
    BodySpec chassis, left, right;
    chassis.name = "chassis";
    chassis.geoms = {box("hull", {0.30, 0.20, 0.10}, 1, {0, 0, 0.09}),
                     round("slider", GeomShape::Sphere, 0.02, 0, 2, {-0.12, 0, 0.02}),
                     box("bumper", {0.02, 0.30, 0.04}, 3, {0.16, 0, 0.07})};
    const Vec3 onSide{0, 0, std::numbers::pi / 2};
    left.name = "leftWheel";
    left.pose.position = {0.06, 0.125, 0.05};
    left.geoms = {round("tyre", GeomShape::Cylinder, 0.05, 0.03, 4, Vec3::Zero(), onSide)};
    right = left;
    right.name = "rightWheel";
    right.pose.position.y() = -0.125;
    config->bodies = {chassis, left, right};
    return config;
}

StaticSpec fixed(std::string name, std::vector<GeomSpec> geoms) {
    StaticSpec s;
    s.name = std::move(name);
    s.geoms = std::make_shared<const std::vector<GeomSpec>>(std::move(geoms));
    return s;
}

StaticSpec arena(double side) {
    const double t = 0.1, h = 0.3, m = (side + t) / 2;
    return fixed("arena", {geom("floor", GeomShape::Plane, 6, Vec3::Zero()), box("north", {side + 2 * t, t, h}, 5, {0, m, h / 2}),
                           box("south", {side + 2 * t, t, h}, 5, {0, -m, h / 2}), box("east", {t, side, h}, 5, {m, 0, h / 2}),
                           box("west", {t, side, h}, 5, {-m, 0, h / 2})});
}

} // namespace

std::shared_ptr<ExperimentSpec> sampleExperiment(const SampleOptions& options) {
    auto experiment = std::make_shared<ExperimentSpec>();
    experiment->materials = materials();
    const auto config = simpleRobot();
    const int columns = static_cast<int>(std::ceil(std::sqrt(options.robots)));
    for (int i = 0; i < options.robots; ++i) {
        RobotSpec robot;
        robot.name = "robot" + std::to_string(i);
        robot.config = config;
        const double middle = 0.5 * (columns - 1);
        robot.pose.position = {(i % columns - middle) * options.spacing, (i / columns - middle) * options.spacing, 0};
        robot.pose.rotation = rotationFromHpr({i * 0.7, 0, 0});
        experiment->robots.push_back(robot);
    }
    if (options.arena) experiment->statics.push_back(arena(options.side));
    return experiment;
}

std::shared_ptr<ExperimentSpec> boxOnFloor(const Vec3& size, const Vec3& middle) {
    auto experiment = sampleExperiment({0, 1, false, 4});
    GeomSpec floor, box;
    floor.name = "floor";
    floor.shape = GeomShape::Plane;
    floor.material = 6;
    box.name = "box";
    box.size = size;
    box.pose.position = middle;
    StaticSpec fixed;
    fixed.name = "yard";
    fixed.geoms = std::make_shared<const std::vector<GeomSpec>>(std::vector{floor, box});
    experiment->statics = {fixed};
    return experiment;
}

std::shared_ptr<ExperimentSpec> lampExperiment(const std::vector<Vec3>& places, double radius) {
    auto experiment = std::make_shared<ExperimentSpec>();
    experiment->materials.resize(1);
    experiment->materials[0].colour = {0, 0, 0};
    experiment->materials[0].emission = {1, 0, 0};
    std::vector<GeomSpec> lamps;
    for (std::size_t i = 0; i < places.size(); ++i)
        lamps.push_back(round("lamp" + std::to_string(i), GeomShape::Sphere, radius, 0, 0, places[i]));
    experiment->statics.push_back(fixed("lamps", lamps));
    return experiment;
}

std::shared_ptr<ExperimentSpec> shapesExperiment() {
    auto experiment = sampleExperiment({2, 1.2, true, 5});
    auto pyramid = std::make_shared<TriangleMesh>();
    pyramid->points = {{-0.3, -0.3, 0}, {0.3, -0.3, 0}, {0.3, 0.3, 0}, {-0.3, 0.3, 0}, {0, 0, 0.6}};
    pyramid->triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {0, 2, 1}, {0, 3, 2}};
    auto hill = std::make_shared<HeightMap>();
    hill->columns = hill->rows = 40;
    for (int j = 0; j < 40; ++j) {
        for (int i = 0; i < 40; ++i)
            hill->heights.push_back(
                float(std::pow(std::sin(i * std::numbers::pi / 39) * std::sin(j * std::numbers::pi / 39), 2)));
    }
    GeomSpec mesh = geom("pyramid", GeomShape::Convex, 7, {1.4, 1.4, 0});
    mesh.mesh = pyramid;
    GeomSpec field = geom("hill", GeomShape::Heightfield, 10, {-1.4, 1.4, 0.001});
    field.heightMap = hill;
    field.size = {1.6, 1.6, 0.4};
    GeomSpec missing = geom("missing", GeomShape::Mesh, 0, {0, 1.8, 0.05});
    experiment->statics.push_back(
        fixed("things", {mesh, field, missing, round("pill", GeomShape::Capsule, 0.12, 0.4, 9, {0.9, -1.2, 0.32}),
                         round("ball", GeomShape::Sphere, 0.25, 0, 3, {0, 0.6, 0.25}),
                         round("column", GeomShape::Cylinder, 0.15, 0.8, 10, {-1.8, -1.2, 0.4}),
                         box("glass", {0.5, 0.5, 0.5}, 8, {1.8, -0.4, 0.25}, {0.5, 0, 0}),
                         box("crate", {0.4, 0.4, 0.4}, 5, {-1.2, -0.4, 0.2}, {0.3, 0, 0})}));
    return experiment;
}

} // namespace trundle
