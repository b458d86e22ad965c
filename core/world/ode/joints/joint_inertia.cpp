#include "world/ode/joints/joint_inertia.h"

#include <algorithm>

#include <Eigen/Dense>

#include "world/ode/objects/ode_math.h"

namespace trundle {

namespace {

constexpr std::size_t kMaxBodies = 24; // farther ones are left out, which makes the result smaller
constexpr double kFixed = 1e6;         // inertia of the world, in those of the body fixed to it

constexpr double kGive = 1e-9; // of a row, as a share of its own mobility

/// Of the axis about which it turns.
Eigen::Index turningColumn(const OdeJoint& joint) { return joint.type == JointType::Suspension ? 1 : 0; }

} // namespace

void JointInertias::add(std::uint32_t index) {
    const OdeJoint& joint = m_joints[index];
    m_jointsOf.resize(m_bodies.size());
    m_jointsOf[joint.child].push_back(index);
    if (joint.parent != kNone) m_jointsOf[joint.parent].push_back(index);
}

/// The motions that a joint leaves free; those of its motor and springs, in the order of their rows.
JointInertias::Axes JointInertias::axesOf(const OdeJoint& joint) const {
    const OdeBody& child = m_bodies[joint.child];
    const Vec3 arm = m_origin - vec(child.p) - turn(child.r, joint.childAnchor);
    const auto about = [&](const Vec3& axis) { return (Vec6() << axis, axis.cross(arm)).finished(); };
    const auto along = [](const Vec3& axis) { return (Vec6() << Vec3::Zero(), axis).finished(); };
    const auto carried = [&](const Vec3& axis) { return joint.parent == kNone ? axis : turn(m_bodies[joint.parent].r, axis); };
    Axes axes(6, 0);
    const auto add = [&](const Vec6& axis) {
        axes.conservativeResize(6, axes.cols() + 1);
        axes.col(axes.cols() - 1) = axis;
    };
    switch (joint.type) {
    case JointType::Hinge: add(about(carried(joint.parentAxis))); break;
    case JointType::Slider: add(along(carried(joint.parentAxis))); break;
    case JointType::Ball:
        for (int k = 0; k < 3; ++k) add(about(Vec3::Unit(k)));
        break;
    case JointType::Universal:
        add(about(carried(joint.parentAxis)));
        add(about(turn(child.r, joint.secondAxis)));
        break;
    case JointType::Fixed: break;
    case JointType::Suspension:
        add(along(carried(joint.slideAxis)));
        add(about(turn(child.r, joint.childAxis)));
        break;
    }
    return axes;
}

JointInertias::Mat6 JointInertias::inertiaOf(std::uint32_t index) const {
    const OdeBody& body = m_bodies[index];
    dMass mass;
    dBodyGetMass(body.id, &mass);
    const Mat3 rotation = matrix(body.r), c = crossing(vec(body.p) - m_origin);
    Mat3 own;
    own << mass.I[0], mass.I[1], mass.I[2], mass.I[4], mass.I[5], mass.I[6], mass.I[8], mass.I[9], mass.I[10];
    Mat6 out;
    out.topLeftCorner<3, 3>() = rotation * own * rotation.transpose() - mass.mass * c * c;
    out.topRightCorner<3, 3>() = mass.mass * c;
    out.bottomLeftCorner<3, 3>() = -mass.mass * c;
    out.bottomRightCorner<3, 3>() = mass.mass * Mat3::Identity();
    return out;
}

/// The rate about the axis that a joint's rotors turn about.
JointInertias::Vec6 JointInertias::turningOf(const OdeJoint& joint, const Axes& axes) {
    return (Vec6() << axes.col(turningColumn(joint)).head<3>(), Vec3::Zero()).finished();
}

/// The rotors turn at s = w + g q: w of the other side, g the ratio seen from there.
JointInertias::Side JointInertias::sideWithRotors(const OdeJoint& joint, bool isChild, const Mat6& inertia) const {
    const Axes axes = axesOf(joint);
    Side side{inertia, inertia * axes, {}};
    side.own = axes.transpose() * side.mixed;
    const Eigen::Index about = turningColumn(joint);
    for (const auto& rotor : joint.rotors) {
        const double ratio = isChild ? rotor->ratio : 1 - rotor->ratio;
        const Vec6 turning = turningOf(joint, axes);
        side.total += rotor->inertia * turning * turning.transpose();
        side.mixed.col(about) += rotor->inertia * ratio * turning;
        side.own(about, about) += rotor->inertia * ratio * ratio;
    }
    return side;
}

/// What a joint passes on of the inertia of its child's side or its parent's.
JointInertias::Mat6 JointInertias::throughJoint(const OdeJoint& joint, bool isChild, const Mat6& inertia) const {
    if (joint.type == JointType::Fixed) return inertia;
    const Side side = sideWithRotors(joint, isChild, inertia);
    return side.total - side.mixed * side.own.inverse() * side.mixed.transpose();
}

/// The inertia of a body and of all that it carries, except by one joint.
JointInertias::Mat6 JointInertias::sideOf(std::uint32_t body, std::uint32_t without) {
    m_visited.push_back(body);
    Mat6 total = inertiaOf(body);
    const Mat6 world = kFixed * total.diagonal().maxCoeff() * Mat6::Identity();
    for (const std::uint32_t index : m_jointsOf[body]) {
        if (index == without) continue;
        const OdeJoint& joint = m_joints[index];
        const std::uint32_t other = joint.child == body ? joint.parent : joint.child;
        if (other == kNone) {
            total += throughJoint(joint, false, world);
            continue;
        }
        if (m_visited.size() >= kMaxBodies || std::find(m_visited.begin(), m_visited.end(), other) != m_visited.end()) continue;
        total += throughJoint(joint, other == joint.child, sideOf(other, index));
    }
    return total;
}

void JointInertias::update(OdeJoint& joint, std::uint32_t index) {
    m_origin = vec(m_bodies[joint.child].p);
    m_visited.clear();
    const Axes axes = axesOf(joint);
    const auto write = [&](const auto& inertia, Vec3& out) {
        const auto free = inertia.inverse().eval();
        for (int k = 0; k < axes.cols(); ++k) out[k] = 1 / free(k, k);
    };
    const auto along = [&](const Mat6& inertia, Vec3& out) { write((axes.transpose() * inertia * axes).eval(), out); };
    const Mat6 child = sideOf(joint.child, index);
    joint.childSide = m_visited;
    if (joint.parent == kNone) {
        along(child, joint.inertia);
        joint.heldInertia = joint.inertia;
        return;
    }
    const bool loop = std::find(m_visited.begin(), m_visited.end(), joint.parent) != m_visited.end();
    const Mat6 parent = loop ? inertiaOf(joint.parent) : sideOf(joint.parent, index);
    if (joint.rotors.empty()) {
        along((child.inverse() + parent.inverse()).inverse(), joint.inertia);
        along(parent, joint.heldInertia);
        return;
    }
    const Side moved = sideWithRotors(joint, true, child);
    write((moved.own - moved.mixed.transpose() * (moved.total + parent).inverse() * moved.mixed).eval(), joint.inertia);
    write(sideWithRotors(joint, false, parent).own, joint.heldInertia);
}

std::vector<std::uint32_t> JointInertias::around(std::uint32_t first, std::uint32_t second) const {
    std::vector<std::uint32_t> found{first};
    if (second != kNone) found.push_back(second);
    for (std::size_t i = 0; i < found.size() && found.size() < kMaxBodies; ++i) {
        if (found[i] >= m_jointsOf.size()) continue;
        for (const std::uint32_t index : m_jointsOf[found[i]])
            for (const std::uint32_t body : {m_joints[index].child, m_joints[index].parent})
                if (body != kNone && found.size() < kMaxBodies && std::ranges::find(found, body) == found.end())
                    found.push_back(body);
    }
    std::ranges::sort(found);
    return found;
}

Eigen::Index JointInertias::columnOf(std::span<const std::uint32_t> bodies, std::uint32_t body) {
    const auto found = std::ranges::lower_bound(bodies, body);
    return found != bodies.end() && *found == body ? 6 * (found - bodies.begin()) : -1;
}

/// Those of the joints between these bodies; a rotor is one with the give of its inertia (rotor_row.h).
std::vector<JointInertias::Row> JointInertias::rowsOf(std::span<const std::uint32_t> bodies) const {
    std::vector<Row> rows;
    for (const std::uint32_t body : bodies)
        for (const std::uint32_t index : body < m_jointsOf.size() ? m_jointsOf[body] : std::vector<std::uint32_t>()) {
            const OdeJoint& joint = m_joints[index];
            if (body != joint.child && columnOf(bodies, joint.child) >= 0) continue; // once, at its child
            const Eigen::Index child = columnOf(bodies, joint.child),
                               parent = joint.parent == kNone ? -1 : columnOf(bodies, joint.parent);
            if (child < 0 || (parent < 0 && joint.parent != kNone)) continue; // to a body that is left out
            const Axes axes = axesOf(joint);
            const Mat6 all = axes.cols() == 0 ? Mat6(Mat6::Identity()) : Mat6(axes.householderQr().householderQ());
            for (Eigen::Index k = axes.cols(); k < 6; ++k) rows.push_back({child, parent, all.col(k), -all.col(k)});
            for (const auto& rotor : joint.rotors) {
                const Vec6 turning = turningOf(joint, axes);
                rows.push_back({child, parent, rotor->ratio * turning, (1 - rotor->ratio) * turning, 1 / rotor->inertia});
            }
        }
    return rows;
}

/// Method: with mass matrix M, rows G of joints and contacts and the row w of the force, its mobility is w M^-1 w less what the joints
/// take of it, (G M^-1 w) (G M^-1 G)^-1 (G M^-1 w). A little give in every row lets loops have too many of them.
double JointInertias::between(std::span<const std::uint32_t> bodies, std::span<const Push> pair, std::span<const Push> contacts) {
    using Matrix = Eigen::MatrixXd;
    m_origin = vec(m_bodies[bodies[0]].p);
    const auto rowOf = [&](const Push& push) {
        return (Vec6() << (push.point - m_origin).cross(push.direction), push.direction).finished();
    };
    std::vector<Row> rows = rowsOf(bodies);
    for (const Push& contact : contacts) rows.push_back({columnOf(bodies, contact.body), -1, rowOf(contact), Vec6::Zero()});
    const auto size = static_cast<Eigen::Index>(6 * bodies.size()), count = static_cast<Eigen::Index>(rows.size());
    Matrix g = Matrix::Zero(count, size), weighted(size, count); // weighted: M^-1 G^T
    for (Eigen::Index i = 0; i < count; ++i) {
        const Row& row = rows[static_cast<std::size_t>(i)];
        g.row(i).segment<6>(row.child) += row.ofChild.transpose();
        if (row.parent >= 0) g.row(i).segment<6>(row.parent) += row.ofParent.transpose();
    }
    Eigen::VectorXd force = Eigen::VectorXd::Zero(size), moved(size);
    force.segment<6>(columnOf(bodies, pair[0].body)) += rowOf(pair[0]);
    if (pair.size() > 1) force.segment<6>(columnOf(bodies, pair[1].body)) -= rowOf(pair[1]);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(6 * i);
        const Mat6 inverse = inertiaOf(bodies[i]).inverse();
        if (count > 0) weighted.middleRows<6>(at) = inverse * g.middleCols<6>(at).transpose();
        moved.segment<6>(at) = inverse * force.segment<6>(at);
    }
    double mobility = force.dot(moved);
    const double free = mobility;
    if (count > 0) {
        Matrix held = g * weighted;
        held.diagonal() *= 1 + kGive;
        for (Eigen::Index i = 0; i < count; ++i) held(i, i) += rows[static_cast<std::size_t>(i)].give;
        const Eigen::VectorXd rates = g * moved;
        mobility -= rates.dot(held.ldlt().solve(rates));
    }
    return 1 / std::max(mobility, kGive * free);
}

} // namespace trundle
