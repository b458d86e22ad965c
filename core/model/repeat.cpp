#include "model/repeat.h"

#include <numbers>

namespace trundle {

std::size_t memberCount(const std::vector<double>& counts) {
    double count = counts.empty() ? 0 : 1;
    for (const double n : counts) count *= n;
    return static_cast<std::size_t>(count);
}

std::vector<double> countsOf(const Part& part, Evaluator& evaluator, ParamScope& scope, const GivenValue* set,
                             Diagnostics& diagnostics) {
    const Property* property = part.kind->find("Count");
    const SourceAssignment* own = part.assignments.find("Count");
    std::optional<GivenValue> given;
    if (set) given = *set;
    else if (own) given = evaluator.evaluate(*own->value, own->file, scope);
    const std::optional<PropertyValue> value = given ? readValue(*property, *given, diagnostics) : std::nullopt;
    return value ? value->numbers : std::vector<double>();
}

void setIndex(ParamScope& scope, std::size_t member, const std::vector<double>& counts) {
    const bool isTwo = counts.size() > 1;
    const std::size_t first = isTwo ? static_cast<std::size_t>(counts[0]) : member + 1;
    scope.set("index", static_cast<double>(member % first));
    if (isTwo) scope.set("index2", static_cast<double>(member / first));
}

bool isIndexUsed(const ParamScope& scope) { return scope.isUsed("index") || scope.isUsed("index2"); }

Pose memberPose(const RingFields& ring, std::size_t member) {
    const Vec3 axis = Vec3(ring.axis.data()).normalized();
    const double angle = static_cast<double>(member) * 360 / ring.count * (std::numbers::pi / 180);
    double s = 0, c = 1;
    detail::halfSinCos(angle, s, c);
    const Quat turn(c, s * axis.x(), s * axis.y(), s * axis.z());
    Vec3 outwards = Vec3::UnitX() - axis.x() * axis;
    if (!(outwards.norm() > 1e-9)) outwards = Vec3::UnitY();
    const Pose inRing{turn * Vec3(ring.radius * outwards.normalized()), turn};
    return Pose{Vec3(ring.pos.data()), rotationFromHpr(Vec3(ring.hpr.data()))} * inRing;
}

} // namespace trundle
