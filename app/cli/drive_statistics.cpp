#include "cli/drive_statistics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trundle {
namespace {

double wrapped(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

/// As DriveProfile refuses an amount; a command of no number, too.
bool isRefused(double velocity, double amount) { return amount != 0 && !(velocity * amount > 0 && std::isfinite(amount)); }

} // namespace

DriveStatistics::DriveStatistics(const World& world) {
    const std::vector<RobotSpec>& robots = world.experiment().robots;
    const std::span<const double> slots = world.block().slots();
    for (std::size_t i = 0; i < robots.size(); ++i) {
        for (const ComponentSpec& device : robots[i].config->devices) {
            const auto find = [&](const char* signal) {
                return world.layout().find(robots[i].name + "/" + device.name + "/" + signal);
            };
            const auto pose = find("pose");
            if (!pose || pose->count != 3) continue;
            const std::array commands{find("linearVelocity"), find("angularVelocity"), find("linearAmount"),
                                      find("angularAmount")};
            const auto sequence = find("sequence");
            const auto done = find("done");
            if (find("lateralVelocity")) continue; // its way is not that of its heading
            if (!sequence || !done || !std::ranges::all_of(commands, [](const auto& command) { return command.has_value(); }))
                continue;
            const std::uint32_t p = pose->offset;
            Drive drive;
            drive.totals.robot = i;
            for (std::size_t c = 0; c < drive.commands.size(); ++c) drive.commands[c] = commands[c]->offset;
            drive.pose = p;
            drive.sequence = sequence->offset;
            drive.done = done->offset;
            drive.x = slots[p];
            drive.y = slots[p + 1];
            drive.heading = slots[p + 2];
            m_drives.push_back(drive);
        }
    }
}

/// A command may specify only the distance or only the angle; the other one then follows from the speeds.
void DriveStatistics::addCommand(Drive& drive, std::span<const double> slots) {
    const double speed = slots[drive.commands[0]], rate = slots[drive.commands[1]];
    double distance = slots[drive.commands[2]], angle = slots[drive.commands[3]];
    drive.lastSequence = slots[drive.sequence];
    if (isRefused(speed, distance) || isRefused(rate, angle)) return;
    if (angle == 0 && speed != 0) angle = rate * std::fabs(distance / speed);
    else if (distance == 0 && rate != 0) distance = speed * std::fabs(angle / rate);
    drive.totals.commandedDistance += distance;
    drive.totals.commandedAngle += angle;
    drive.amountDistance = distance;
    drive.amountAngle = angle;
    drive.drivenBefore = drive.totals.drivenDistance;
    drive.turnedBefore = drive.totals.drivenAngle;
    drive.running = true; // a replaced command has not ended
    drive.commanded = true;
}

void DriveStatistics::endAmount(Drive& drive) {
    DriveTotals& totals = drive.totals;
    const double distance = totals.drivenDistance - drive.drivenBefore - drive.amountDistance;
    const double angle = totals.drivenAngle - drive.turnedBefore - drive.amountAngle;
    totals.distanceError += distance;
    totals.angleError += angle;
    ++totals.ended;
    drive.running = false;
}

void DriveStatistics::afterTick(const World& world) {
    const std::span<const double> slots = world.block().slots();
    for (Drive& drive : m_drives) {
        if (slots[drive.sequence] != drive.lastSequence) addCommand(drive, slots);
        const auto& c = drive.commands;
        const bool hasAmount = slots[c[2]] != 0 || slots[c[3]] != 0;
        if (!hasAmount && (slots[c[0]] != 0 || slots[c[1]] != 0)) drive.totals.freely = true;
        drive.totals.underWay = slots[drive.done] == 0;
        const double x = slots[drive.pose], y = slots[drive.pose + 1], heading = slots[drive.pose + 2];
        const double turn = wrapped(heading - drive.heading);
        const double middle = drive.heading + turn / 2;
        const double chord = (x - drive.x) * std::cos(middle) + (y - drive.y) * std::sin(middle);
        // A chord is shorter than its arc by the factor sin(a)/a, where a is half of the turn.
        const double half = turn / 2;
        drive.totals.drivenDistance += std::fabs(half) > 1e-6 ? chord * half / std::sin(half) : chord;
        drive.totals.drivenAngle += turn;
        if (drive.running && !drive.totals.underWay) endAmount(drive);
        drive.x = x;
        drive.y = y;
        drive.heading = heading;
    }
}

std::vector<DriveTotals> DriveStatistics::totals() const {
    std::vector<DriveTotals> totals;
    for (const Drive& drive : m_drives)
        if (drive.commanded && !drive.totals.freely) totals.push_back(drive.totals);
    return totals;
}

} // namespace trundle
