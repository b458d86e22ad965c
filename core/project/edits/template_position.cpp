#include "project/edits/template_position.h"

#include <algorithm>
#include <cmath>

#include "model/dotted_path.h"
#include "model/resolve/footprint.h"
#include "project/objects/part_values.h"

namespace trundle {
namespace {

constexpr double kWidth = 0.1;  ///< m
constexpr double kGrain = 1e-3; ///< m, of positions

std::optional<GeomShape> shapeOf(std::string_view kind) {
    if (kind == "Box") return GeomShape::Box;
    if (kind == "Sphere") return GeomShape::Sphere;
    if (kind == "Cylinder") return GeomShape::Cylinder;
    if (kind == "Capsule") return GeomShape::Capsule;
    return std::nullopt;
}

/// A geom as the experiment has it, with its mesh; nullptr if its config has no instance.
const GeomSpec* resolved(const LoadedProject& loaded, const Part& part) {
    for (const RobotSpec& robot : loaded.experiment->robots) {
        if (!robot.config) continue;
        for (const BodySpec& body : robot.config->bodies)
            for (const GeomSpec& geom : body.geoms)
                if (geom.range == part.range) return &geom;
    }
    return nullptr;
}

/// The path under which `target` is reached: `path`, or what that is in.
std::string pathOf(const LoadedProject& loaded, const std::string& path, const Part& target) {
    for (std::string at = path; !at.empty(); at = withoutLastWord(at)) {
        const auto place = placeOf(loaded, at);
        if (!place || !place->part) continue;
        if (place->part == &target || (isPlaced(*place->part) && configOf(loaded, *place->part) == &target)) return at;
    }
    return path;
}

} // namespace

std::optional<GeomSpec> shapeAt(const LoadedProject& loaded, const ObjectLocation& place) {
    const std::optional<GeomShape> shape = place.part->kind ? shapeOf(place.part->kind->name) : std::nullopt;
    if (!shape) {
        const GeomSpec* spec = resolved(loaded, *place.part);
        return spec ? std::optional<GeomSpec>(*spec) : std::nullopt;
    }
    const auto number = [&](const char* key, std::size_t at = 0) {
        const auto value = valueAt(loaded, place, key);
        return value && at < value->numbers.size() ? value->numbers[at] : 0.0;
    };
    GeomSpec geom;
    geom.shape = *shape;
    geom.pose = poseAt(loaded, place);
    geom.size = {number("Size", 0), number("Size", 1), number("Size", 2)};
    geom.radius = number("Radius");
    geom.length = number("Length");
    return geom;
}

namespace {

/// The highest z (m, config frame) of the geoms of a body with pose `X_CB`.
std::optional<double> topOf(const LoadedProject& loaded, const std::string& path, const Part& body, const Pose& X_CB) {
    std::optional<double> top;
    for (const Part& part : body.parts) {
        const auto place = part.is(Role::Geom) ? placeOf(loaded, path + "." + part.name) : std::nullopt;
        const std::optional<GeomSpec> geom = place && place->part ? shapeAt(loaded, *place) : std::nullopt;
        for (const Footprint& foot : geom ? footprintsOf(*geom, X_CB) : std::vector<Footprint>())
            top = std::max(top.value_or(foot.high), foot.high);
    }
    return top;
}

} // namespace

std::optional<GeomSpec> templateShape(const Kind& kind) {
    const std::optional<GeomShape> shape = shapeOf(kind.name);
    if (!shape) return std::nullopt;
    GeomSpec geom;
    geom.shape = *shape;
    geom.size = Vec3::Constant(kWidth);
    geom.radius = geom.length = kWidth;
    return geom;
}

Vec3 templatePosition(const LoadedProject& loaded, const std::string& given, const Part& target, const GeomSpec& shape) {
    const std::string path = pathOf(loaded, given, target);
    Pose X_CT; // of the target's frame in the config's
    std::optional<double> top;
    const auto poseOf = [&](const std::string& of) {
        const auto place = placeOf(loaded, of);
        if (!place || !place->part) return Pose();
        const bool isInPart = std::ranges::any_of(place->above, &Part::isPartUse); // it is placed in the PartConfig
        return isInPart ? poseAt(loaded, *place) : poseInConfig(loaded, *place);
    };
    if (target.is(Role::Body)) {
        X_CT = poseOf(path);
        top = topOf(loaded, path, target, X_CT);
    } else if (target.kind && target.kind->name == "RobotConfig") {
        for (const Part& body : target.parts)
            if (body.is(Role::Body))
                if (const auto high = topOf(loaded, path + "." + body.name, body, poseOf(path + "." + body.name)))
                    top = std::max(top.value_or(*high), *high);
    }
    const std::vector<Footprint> own = footprintsOf(shape, X_CT);
    if (own.empty()) return Vec3::Zero();
    const double rise = top ? *top - own.front().low : std::max(0.0, -own.front().low); // 0 is the floor's height
    return X_CT.rotation.conjugate() * Vec3(0, 0, std::ceil(rise / kGrain - 1e-6) * kGrain);
}

} // namespace trundle
