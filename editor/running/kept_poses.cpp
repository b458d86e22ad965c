#include "editor/running/kept_poses.h"

#include <cmath>
#include <numbers>

#include <QCoreApplication>

#include "model/outline.h"

namespace trundle {
namespace {

constexpr double kPosStep = 1e-6, kAngleStep = 1e-4; // m, degrees

Vec3 rounded(const Vec3& v, double step) {
    Vec3 out;
    for (int k = 0; k < 3; ++k) {
        const double steps = std::round(v[k] / step);
        out[k] = steps == 0 ? 0 : steps / std::round(1 / step); // a division, so that 0.3 is written 0.3
    }
    return out;
}

/// Without exponents, as people write places.
std::string plainText(double value) {
    QString text = QString::number(value, 'f', 6);
    while (text.endsWith(QLatin1Char('0'))) text.chop(1);
    if (text.endsWith(QLatin1Char('.'))) text.chop(1);
    return text.toStdString();
}

std::string tripleText(const Vec3& v) { return plainText(v.x()) + ", " + plainText(v.y()) + ", " + plainText(v.z()); }

Vec3 degreesOf(const Pose& pose) { return hprFromRotation(pose.rotation) * (180 / std::numbers::pi); }

bool isElsewhere(const Pose& a, const Pose& b) {
    if ((a.position - b.position).cwiseAbs().maxCoeff() > kPosStep / 2) return true;
    return a.rotation.angularDistance(b.rotation) > kAngleStep / 2 * std::numbers::pi / 180;
}

QString trPoses(const char* text) { return QCoreApplication::translate("RunSession", text); }

} // namespace

KeptPoses keptPoses(const Loaded& loaded, const std::function<std::optional<Pose>(const std::string&)>& poseNow) {
    KeptPoses kept;
    for (const RobotSpec& robot : loaded.experiment->robots) {
        const std::optional<Pose> now = poseNow(robot.name);
        if (!now || !isElsewhere(*now, robot.pose)) continue;
        if (!loaded.outline->world.find(robot.name)) {
            const Part* layout = layoutOfMember(*loaded.outline, robot.name);
            const QString name = QString::fromStdString(layout ? layout->name : robot.name);
            kept.refusal =
                trPoses("%1 moved as one of many: its members have no start of their own. Replace %2 by single instances first.")
                    .arg(QString::fromStdString(robot.name), name);
            kept.values.clear();
            return kept;
        }
        kept.values.push_back({robot.name + ".Pos", tripleText(rounded(now->position, kPosStep))});
        kept.values.push_back({robot.name + ".HPR", tripleText(rounded(degreesOf(*now), kAngleStep))});
    }
    if (kept.values.empty()) kept.refusal = trPoses("Every robot stands where it starts.");
    return kept;
}

} // namespace trundle
