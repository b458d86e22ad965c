#include "project/edits/plan_sensor_ring.h"

#include <algorithm>
#include <cmath>

#include "model/dotted_path.h"
#include "model/resolve/footprint.h"
#include "project/objects/object_location.h"
#include "project/objects/part_values.h"

namespace trundle {

namespace {

constexpr double kClear = 0.002, kGrain = 1e-3; // m

const BodySpec* resolvedBody(const LoadedProject& loaded, const Part& part) {
    for (const RobotSpec& robot : loaded.experiment->robots) {
        if (!robot.config) continue;
        for (const BodySpec& body : robot.config->bodies)
            if (body.range == part.range && !body.isFixed) return &body;
    }
    return nullptr;
}

double rounded(double value) { return kGrain * std::round(value / kGrain); }

} // namespace

Result<std::string> bodyForSensors(const LoadedProject& loaded, const std::string& path) {
    const Error none{Code::WrongPlace, "select a body, or a robot that has one, first"};
    const std::optional<ObjectLocation> place = path.empty() ? std::nullopt : placeOf(loaded, path);
    if (!place || !place->part || place->member) return none;
    std::string at = path;
    std::vector<const Part*> chain = place->above;
    chain.push_back(place->part);
    for (auto it = chain.rbegin(); it != chain.rend() && !at.empty(); ++it, at = withoutLastWord(at))
        if ((*it)->is(Role::Body)) return at;
    const Part& part = *place->part;
    const Part* const config = part.is(Role::Config) ? &part : isPlaced(part) ? configOf(loaded, part) : nullptr;
    for (const Part& inner : config ? config->parts : std::vector<Part>())
        if (inner.is(Role::Body) && inner.usable) return path + "." + inner.name;
    return none;
}

SensorRing proposedRing(const LoadedProject& loaded, const std::string& path) {
    SensorRing ring;
    const std::optional<ObjectLocation> place = placeOf(loaded, path);
    const BodySpec* const body = place && place->part ? resolvedBody(loaded, *place->part) : nullptr;
    double reach = 0, low = HUGE_VAL, high = -HUGE_VAL;
    for (const GeomSpec& geom : body ? body->geoms : std::vector<GeomSpec>())
        for (const Footprint& foot : footprintsOf(geom, Pose())) {
            for (const Eigen::Vector2d& corner : foot.corners) reach = std::max(reach, corner.norm() + foot.grown);
            low = std::min(low, foot.low);
            high = std::max(high, foot.high);
        }
    if (!(reach > 0) || low > high) return ring;
    ring.radius = kGrain * std::ceil((reach + kClear) / kGrain - 1e-6);
    ring.height = rounded((low + high) / 2);
    return ring;
}

Result<EditPlan> planSensorRing(const LoadedProject& loaded, const std::string& body, const SensorRing& ring) {
    const std::optional<ObjectLocation> place = placeOf(loaded, body);
    if (!place || !place->part || !place->part->is(Role::Body)) return Error{Code::NoSuchPath, body + " is no body"};
    const std::string name(lastWord(body));
    std::string text = "Ring ranger { Count=" + std::to_string(ring.count) + " Radius=" + shortNumber(ring.radius);
    if (ring.height != 0) text += " Pos=0,0," + shortNumber(ring.height);
    text += "\n  RangeSensor eye { Body=" + name + " Type=" + ring.type + " MaxRange=" + shortNumber(ring.maxRange) + " }\n}";
    return planInsert(loaded, body, text);
}

} // namespace trundle
