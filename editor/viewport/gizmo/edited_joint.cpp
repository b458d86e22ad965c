#include "editor/viewport/gizmo/edited_joint.h"

#include <algorithm>
#include <array>
#include <numbers>

#include <QCoreApplication>

#include "editor/document/selection.h"
#include "editor/document/structure_edits.h"
#include "editor/viewport/context/view_context.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/gizmo/text_in_place.h"
#include "lang/number_text.h"
#include "model/dotted_path.h"
#include "model/shortest_turn.h"

namespace trundle {
namespace {

constexpr double kAxisFine = 1e-4, kPerRad = 180 / std::numbers::pi, kSquare = 1e-6;
constexpr const char* kJointKeys[] = {"Anchor",   "Axis",      "Axis2",     "LowStop", "HighStop",
                                      "LowStop2", "HighStop2", "SwingStop", "Travel"};

std::array<double, 3> numbersOf(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

QString trJoint(const char* text) { return QCoreApplication::translate("EditedJoint", text); }

QString titleOf(const char* text, const std::string& path) { return trJoint(text).arg(QString::fromStdString(path)); }

/// The joint of a path: itself, or that of a device with a Joint.
std::string jointPathOf(const LoadedProject& loaded, const std::string& path) {
    const auto place = placeOf(loaded, path);
    if (!place || !place->part) return {};
    if (place->part->is(Role::Joint)) return path;
    if (!place->part->is(Role::Device) || !place->part->kind || !place->part->kind->find("Joint")) return {};
    const auto joint = valueAt(loaded, *place, "Joint");
    return joint && joint->texts.size() == 1 ? std::string(withoutLastWord(path)) + "." + joint->texts[0] : std::string();
}

} // namespace

std::optional<EditedJoint> EditedJoint::selected(const ViewContext& context) {
    if (context.selection.paths().size() != 1 || context.world.isRunning() || !context.document.isOpen()) return std::nullopt;
    const LoadedProject& loaded = *context.document.loaded();
    const std::string path = jointPathOf(loaded, context.selection.current());
    if (path.empty()) return std::nullopt;
    EditedJoint joint;
    joint.find(context, path, true);
    if (joint.m_path.empty()) joint.find(context, path, false);
    if (joint.m_path.empty()) joint.findLink(context, path);
    if (joint.m_path.empty() || isLocked(context.world, joint.m_path)) return std::nullopt;
    if (const auto place = placeOf(loaded, joint.m_placePath)) joint.m_described = describedFrame(loaded, *place);
    joint.m_anchorText = textInPlace(loaded, joint.m_path + ".Anchor");
    joint.m_lowText = textInPlace(loaded, joint.m_path + ".LowStop");
    joint.m_highText = textInPlace(loaded, joint.m_path + ".HighStop");
    joint.m_swingText = textInPlace(loaded, joint.m_path + ".SwingStop");
    joint.m_travelText = textInPlace(loaded, joint.m_path + ".Travel");
    return joint;
}

/// `asInText`: for a path into a config only in a robot that sets none of the values there.
void EditedJoint::find(const ViewContext& context, const std::string& path, bool asInText) {
    const ViewportScene& world = context.world;
    const auto& robots = world.objects()->experiment().robots;
    for (std::uint32_t r = 0; r < robots.size(); ++r) {
        if (!robots[r].config) continue;
        const RobotConfigSpec& config = *robots[r].config;
        const std::string byConfig = "RobotConfig." + config.name;
        const bool isInside = startsWithPath(path, robots[r].name), isInConfig = startsWithPath(path, byConfig);
        if (!isInside && !isInConfig) continue;
        const std::string name = path.substr(std::min(path.size(), (isInside ? robots[r].name : byConfig).size() + 1));
        auto joint = std::ranges::find(config.joints, name, &JointSpec::name);
        if (joint == config.joints.end())
            joint = std::ranges::find_if(config.joints, [&](const JointSpec& j) { return isNameOf(j.name, name); });
        if (joint == config.joints.end()) continue;
        const std::string own = robots[r].name + "." + joint->name;
        if (asInText && !isInside && !hasTextsOf(*context.document.loaded(), path, own, kJointKeys)) continue;
        m_placePath = (isInside ? robots[r].name : byConfig) + "." + joint->name;
        m_path = isInside ? m_placePath : path; // in the text of a config all members of a Repeat are one
        m_spec = *joint;
        m_X_WC = robots[r].pose;
        if (joint->parent != kWorldBody) {
            const auto parent = std::uint32_t(joint->parent);
            m_X_WC = world.poseOf({ObjectKind::Body, r, parent}) * config.bodies[parent].pose.inverse();
            addPoints(config.bodies[parent], config.bodies[parent].pose);
        }
        const BodySpec& child = config.bodies[std::size_t(joint->child)];
        addPoints(child, child.pose);
        m_childCentre = child.pose * child.mass.centre;
        return;
    }
}

/// Of a joint between robots: in the world, at the start.
void EditedJoint::findLink(const ViewContext& context, const std::string& path) {
    const ExperimentSpec& experiment = context.world.objects()->experiment();
    for (const auto& link : experiment.joints) {
        if (link.spec.name != path) continue;
        m_path = m_placePath = path;
        m_spec = link.spec;
        const auto add = [&](int robot, int body) {
            if (robot == kWorldBody || !experiment.robots[std::size_t(robot)].config) return;
            const RobotSpec& owner = experiment.robots[std::size_t(robot)];
            const BodySpec& spec = owner.config->bodies[std::size_t(body)];
            addPoints(spec, owner.pose * spec.pose);
            m_childCentre = owner.pose * spec.pose * spec.mass.centre;
        };
        add(link.parentRobot, link.spec.parent);
        add(link.childRobot, link.spec.child);
        return;
    }
}

/// The origin of the body, the centres of its shapes, and those of their ends or faces.
void EditedJoint::addPoints(const BodySpec& body, const Pose& X_CB) {
    m_points.push_back(X_CB.position);
    for (const GeomSpec& geom : body.geoms) {
        const Pose X_CG = X_CB * geom.pose;
        m_points.push_back(X_CG.position);
        const bool isBox = geom.shape == GeomShape::Box;
        const bool isRound = geom.shape == GeomShape::Cylinder || geom.shape == GeomShape::Capsule;
        if (!isBox && !isRound) continue;
        const Vec3 half = isBox ? Vec3(0.5 * geom.size) : Vec3(0, 0, 0.5 * geom.length);
        for (int k = isBox ? 0 : 2; k < 3; ++k)
            for (const int side : {-1, 1}) m_points.push_back(X_CG * (side * half[k] * Vec3::Unit(k)));
    }
}

Vec3 EditedJoint::zeroDirection(const Vec3& axis) const {
    const Vec3 out = m_childCentre - m_spec.anchor, across = out - out.dot(axis) * axis;
    if (across.norm() > 1e-3) return across.normalized();
    const Vec3 other = std::abs(axis.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitZ();
    return (other - other.dot(axis) * axis).normalized();
}

/// A Slider and a Fixed are the same wherever they are.
bool EditedJoint::canMoveAnchor() const { return m_spec.type != JointType::Slider && m_spec.type != JointType::Fixed; }

bool EditedJoint::hasStops(bool second) const {
    return m_spec.type == JointType::Universal ||
           (!second && (m_spec.type == JointType::Hinge || m_spec.type == JointType::Slider));
}

std::optional<double> EditedJoint::stop(const JointStop& which) const {
    if (which.isSecond) return which.isHigh ? m_spec.highStop2 : m_spec.lowStop2;
    return which.isHigh ? m_spec.highStop : m_spec.lowStop;
}

Vec3 EditedJoint::describedPoint(const Vec3& point) const {
    return m_described.signs.cwiseProduct(m_described.pose.inverse() * point);
}

/// An axis is an axial vector, and its mirror image is reversed where it would point the other way: see model/resolve/mirror.cpp.
bool EditedJoint::isReversed(const Vec3& axis) const {
    const Vec3 v = m_described.pose.rotation.conjugate() * axis;
    return m_described.signs.prod() * m_described.signs.cwiseProduct(v).dot(v) < 0;
}

Vec3 EditedJoint::describedAxis(const Vec3& axis) const {
    const Vec3 v = m_described.pose.rotation.conjugate() * axis,
               image = m_described.signs.prod() * m_described.signs.cwiseProduct(v);
    return isReversed(axis) ? Vec3(-image) : image;
}

std::string EditedJoint::axisText(const Vec3& axis) const {
    const Vec3 d = describedAxis(axis);
    return steppedNumber(d.x(), kAxisFine) + "," + steppedNumber(d.y(), kAxisFine) + "," + steppedNumber(d.z(), kAxisFine);
}

Status EditedJoint::setAnchor(Document& document, const Vec3& anchor, double fine, const std::string& mergeKey) const {
    const auto before = numbersOf(describedPoint(m_spec.anchor)), after = numbersOf(describedPoint(anchor));
    return document.structure().setValues(titleOf("Move anchor of %1", m_path),
                                          {{m_path + ".Anchor", withNumbers(m_anchorText, before, after, "m", fine)}}, mergeKey);
}

Status EditedJoint::setAxis(Document& document, const Vec3& axis, bool second, const std::string& mergeKey) {
    std::vector<ValueEdit> edits;
    Vec3 turned = axis.normalized();
    if (m_spec.type == JointType::Universal && second) turned = (turned - turned.dot(m_spec.axis) * m_spec.axis).normalized();
    if (m_spec.type == JointType::Universal && !second) {
        const bool isSquare = std::abs(turned.dot(m_spec.axis2)) < kSquare;
        m_axis2Edited |= !isSquare; // once a drag has turned it, it is written even where it is as at the start
        const Vec3 axis2 = isSquare ? m_spec.axis2 : Vec3(shortestTurn(m_spec.axis, turned) * m_spec.axis2);
        if (m_axis2Edited) edits.push_back({m_path + ".Axis2", axisText(axis2)});
    }
    edits.push_back({m_path + (second ? ".Axis2" : ".Axis"), axisText(turned)});
    return document.structure().setValues(titleOf("Turn axis of %1", m_path), edits, mergeKey);
}

Status EditedJoint::setStop(Document& document, const JointStop& which, double value, double fine,
                            const std::string& mergeKey) const {
    const bool isReversed = this->isReversed(axis(which.isSecond)), isLength = !turns();
    const bool writesHigh = which.isHigh != isReversed;
    const double scale = (isReversed ? -1 : 1) * (isLength ? 1 : kPerRad);
    const double before = scale * stop(which).value_or(HUGE_VAL), after = scale * value;
    const std::string key = std::string(writesHigh ? ".HighStop" : ".LowStop") + (which.isSecond ? "2" : "");
    const std::string text = withNumbers(which.isSecond ? std::string()
                                         : writesHigh   ? m_highText
                                                        : m_lowText,
                                         {&before, 1}, {&after, 1}, isLength ? "m" : "deg", fine);
    return document.structure().setValues(titleOf("Set stop of %1", m_path), {{m_path + key, text}}, mergeKey);
}

Status EditedJoint::setSwing(Document& document, double value, double fine, const std::string& mergeKey) const {
    const double before = kPerRad * m_spec.swingStop.value_or(HUGE_VAL), after = kPerRad * value;
    return document.structure().setValues(
        titleOf("Set swing of %1", m_path),
        {{m_path + ".SwingStop", withNumbers(m_swingText, {&before, 1}, {&after, 1}, "deg", fine)}}, mergeKey);
}

Status EditedJoint::setTravel(Document& document, double value, double fine, const std::string& mergeKey) const {
    return document.structure().setValues(
        titleOf("Set travel of %1", m_path),
        {{m_path + ".Travel", withNumbers(m_travelText, {&m_spec.travel, 1}, {&value, 1}, "m", fine)}}, mergeKey);
}

} // namespace trundle
