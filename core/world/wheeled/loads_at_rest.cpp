#include "world/wheeled/loads_at_rest.h"

namespace trundle {

std::vector<double> loadsAtRest(std::span<const Vec2> points, const Vec2& middle) {
    std::vector<double> loads(points.size(), 0);
    std::vector<bool> carries(points.size(), true);
    const auto at = [&](std::size_t i) { return Vec3(1, points[i].x(), points[i].y()); };
    for (bool again = true; again;) {
        again = false;
        Mat3 sums = Mat3::Zero();
        for (std::size_t i = 0; i < points.size(); ++i)
            if (carries[i]) sums += at(i) * at(i).transpose();
        const Vec3 slope =
            sums.completeOrthogonalDecomposition().solve(Vec3(1, middle.x(), middle.y())); // all may be on one line
        for (std::size_t i = 0; i < points.size(); ++i) {
            loads[i] = carries[i] ? at(i).dot(slope) : 0;
            if (loads[i] >= 0) continue;
            loads[i] = 0;
            carries[i] = false;
            again = true;
        }
    }
    return loads;
}

double turningLever(std::span<const Vec2> points) {
    const std::vector<double> loads = loadsAtRest(points);
    double moment = 0, sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        moment += loads[i] * points[i].norm();
        sum += loads[i];
    }
    return moment / sum;
}

} // namespace trundle
