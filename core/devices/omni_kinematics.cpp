#include "devices/omni_kinematics.h"

#include <cmath>
#include <utility>

#include <Eigen/Dense>

namespace trundle {
namespace {

constexpr double kLeastDeterminant = 1e-9; // of the normal matrix with its rows scaled to 1

} // namespace

OmniKinematics::OmniKinematics(double r, std::vector<FreeRollingWheel> wheels) : m_wheels(std::move(wheels)) {
    Eigen::MatrixX3d rows(m_wheels.size(), 3);
    for (std::size_t i = 0; i < m_wheels.size(); ++i) {
        const FreeRollingWheel& w = m_wheels[i];
        const double scale = 1 / (r * w.share);
        m_perWheel.push_back({w.gripX * scale, (w.x * w.gripY - w.y * w.gripX) * scale, w.gripY * scale});
        rows.row(static_cast<Eigen::Index>(i)) << m_perWheel[i].linear, m_perWheel[i].lateral, m_perWheel[i].angular;
    }
    const Eigen::Matrix3d normal = rows.transpose() * rows;
    const Eigen::Vector3d sizes = normal.diagonal();
    m_complete = sizes.minCoeff() > 0 && normal.determinant() > kLeastDeterminant * sizes.prod();
    if (!m_complete) return;
    const Eigen::Matrix3Xd inverse = normal.inverse() * rows.transpose();
    for (Eigen::Index i = 0; i < inverse.cols(); ++i) m_inverse.push_back({inverse(0, i), inverse(2, i), inverse(1, i)});
}

double OmniKinematics::wheelFromChassis(std::size_t wheel, const ChassisMotion& chassis) const {
    const ChassisMotion& row = m_perWheel[wheel];
    return row.linear * chassis.linear + row.lateral * chassis.lateral + row.angular * chassis.angular;
}

ChassisMotion OmniKinematics::chassisFromWheels(const std::vector<double>& turned) const {
    ChassisMotion motion;
    for (std::size_t i = 0; i < m_inverse.size(); ++i) {
        motion.linear += m_inverse[i].linear * turned[i];
        motion.lateral += m_inverse[i].lateral * turned[i];
        motion.angular += m_inverse[i].angular * turned[i];
    }
    return motion;
}

PlanePose OmniKinematics::poseFrom(const std::vector<std::array<double, 2>>& middles) const {
    double x = 0, y = 0, ownX = 0, ownY = 0;
    const auto count = static_cast<double>(m_wheels.size());
    for (std::size_t i = 0; i < m_wheels.size(); ++i) {
        x += middles[i][0] / count;
        y += middles[i][1] / count;
        ownX += m_wheels[i].x / count;
        ownY += m_wheels[i].y / count;
    }
    double along = 0, across = 0;
    for (std::size_t i = 0; i < m_wheels.size(); ++i) {
        const double ax = m_wheels[i].x - ownX, ay = m_wheels[i].y - ownY, bx = middles[i][0] - x, by = middles[i][1] - y;
        along += ax * bx + ay * by;
        across += ax * by - ay * bx;
    }
    const double heading = std::atan2(across, along), c = std::cos(heading), s = std::sin(heading);
    return {x - c * ownX + s * ownY, y - s * ownX - c * ownY, heading};
}

} // namespace trundle
