#include "editor/running/start_poses.h"

#include <cmath>
#include <numbers>

#include <QCoreApplication>

#include "lang/number_text.h"
#include "model/outline.h"
#include "model/provenance.h"
#include "project/objects/written_hpr.h"

namespace trundle {
namespace {

constexpr double kPosStep = 1e-6, kAngleStep = 1e-4;   // m, degrees: of the numbers that are written
constexpr double kLeastMove = 1e-4, kLeastTurn = 1e-2; // m, degrees: less is what a robot sinks into the floor
constexpr double kDegrees = 180 / std::numbers::pi;

/// The value as written in the text; empty if it is not set.
std::string textOf(const LoadedProject& loaded, const std::string& property) {
    const auto from = provenanceOf(*loaded.outline, property);
    return from && from->value.known() ? std::string(loaded.sources.slice(from->value)) : std::string();
}

/// The text with new numbers, formatted as by the Move tool. Components that change by less than half a step keep their text.
std::string kept(const std::string& text, const Vec3& before, Vec3 now, const char* unit, double step) {
    for (int k = 0; k < 3; ++k)
        if (std::abs(now[k] - before[k]) < step / 2) now[k] = before[k];
    return withNumbers(text, {before.data(), 3}, {now.data(), 3}, unit, step);
}

/// HPR as text; what the robot's own text has is kept where it is part of the new rotation.
std::string turned(const LoadedProject& loaded, const RobotSpec& robot, const Quat& now) {
    const auto place = placeOf(loaded, robot.name);
    const Vec3 before = place ? writtenHpr(loaded, *place, robot.pose.rotation) : hprFromRotation(robot.pose.rotation);
    return kept(textOf(loaded, robot.name + ".HPR"), before * kDegrees, hprLike(before, now) * kDegrees, "deg", kAngleStep);
}

bool isElsewhere(const Pose& a, const Pose& b) {
    return (a.position - b.position).norm() >= kLeastMove || a.rotation.angularDistance(b.rotation) >= kLeastTurn / kDegrees;
}

QString trPoses(const char* text) { return QCoreApplication::translate("RunSession", text); }

} // namespace

StartPoses startPoses(const LoadedProject& loaded, const std::function<std::optional<Pose>(const std::string&)>& poseNow) {
    StartPoses all;
    QStringList leftOut;
    for (const RobotSpec& robot : loaded.experiment->robots) {
        if (robot.scenery) continue;
        const std::optional<Pose> now = poseNow(robot.name);
        if (now && !isElsewhere(*now, robot.pose)) continue;
        const Part* layout = loaded.outline->world.find(robot.name) ? nullptr : layoutOfMember(*loaded.outline, robot.name);
        const bool isInRepeat = robot.name.find('.') != std::string::npos;
        const QString name = QString::fromStdString(layout ? layout->name : robot.name);
        if (!now) {
            if (leftOut.empty() || leftOut.back() != name) leftOut.append(name);
            continue;
        }
        if (layout && !isInRepeat) {
            all.refusal = trPoses("%1 moved: members of a Grid or Scatter have no start pose of their own. Replace %2 by single "
                                  "instances first.")
                              .arg(QString::fromStdString(robot.name), name);
            all.values.clear();
            return all;
        }
        if (isInRepeat) {
            all.refusal =
                trPoses("%1 moved: the members of a Repeat share one text, so one of them has no start pose of its own. Write %1 "
                        "outside of the Repeat, or have its Pos depend on index.")
                    .arg(QString::fromStdString(robot.name));
            all.values.clear();
            return all;
        }
        const std::string pos = robot.name + ".Pos";
        all.values.push_back({pos, kept(textOf(loaded, pos), robot.pose.position, now->position, "m", kPosStep)});
        all.values.push_back({robot.name + ".HPR", turned(loaded, robot, now->rotation)});
    }
    all.leftOut = leftOut.join(QStringLiteral(", "));
    if (!all.values.empty()) return all;
    all.refusal =
        leftOut.empty()
            ? trPoses("Every robot is at its start pose.")
            : trPoses("%1: new or renamed since the run started. Every other robot is at its start pose.").arg(all.leftOut);
    return all;
}

} // namespace trundle
