#include "project/objects/written_hpr.h"

#include <cmath>
#include <numbers>

#include "project/objects/part_values.h"

namespace trundle {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kSameRotation = 1e-7, kSameAngle = 1e-5; // rad

double withinHalfTurn(double angle) { return std::remainder(angle, 2 * kPi); }

/// The same angle within half a turn of 0; half a turn has the sign that is written.
double angleLike(double written, double angle) {
    const double off = withinHalfTurn(angle - written);
    return std::abs(off) < kSameAngle ? written + off : withinHalfTurn(angle);
}

} // namespace

Vec3 writtenHpr(const LoadedProject& loaded, const ObjectLocation& place, const Quat& rotation) {
    const std::optional<PropertyValue> value = valueAt(loaded, place, "HPR");
    const bool isTriple = value && value->numbers.size() == 3;
    const Vec3 written = isTriple ? Vec3(value->numbers.data()) : Vec3(Vec3::Zero());
    if (rotationFromHpr(written).angularDistance(rotation) > kSameRotation) return hprFromRotation(rotation);
    return written.unaryExpr(&withinHalfTurn);
}

Vec3 hprLike(const Vec3& written, const Quat& rotation) {
    Vec3 hpr = hprFromRotation(rotation);
    if (std::abs(hpr.y()) >= kPi / 2) { // its heading has the whole angle
        hpr.x() += hpr.y() > 0 ? written.z() : -written.z();
        hpr.z() = written.z();
    } else if (std::cos(written.y()) < 0) {
        hpr = {hpr.x() + kPi, kPi - hpr.y(), hpr.z() + kPi};
    }
    for (int k = 0; k < 3; ++k) hpr[k] = angleLike(written[k], hpr[k]);
    return hpr;
}

} // namespace trundle
