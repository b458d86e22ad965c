#include "run/logs/csv.h"
#include "run/logs/log.h"
#include "run/logs/log_choice.h"
#include "run/logs/log_settings.h"
#include "run/logs/signal_columns.h"

namespace trundle {
namespace {

class PoseLog final : public RunLog {
public:
    explicit PoseLog(std::vector<std::size_t> robots) : m_robots(std::move(robots)) {}

    void header(std::string& csv) const override {
        CsvWriter out(csv);
        for (const char* name : {"time [s]", "robot", "x [m]", "y [m]", "z [m]", "heading [deg]", "pitch [deg]", "roll [deg]"})
            out.cell(name);
        out.endRow();
    }

    void rows(const World& world, double time, std::string& csv) override {
        CsvWriter out(csv);
        for (const std::size_t robot : m_robots) {
            if (hasEnded(world, robot)) continue;
            const Pose pose = world.reportedPose(robot);
            const Vec3 hpr = hprFromRotation(pose.rotation).unaryExpr(&readableDegrees);
            out.cell(time).cell(world.experiment().robots[robot].name);
            for (const double v : {pose.position.x(), pose.position.y(), pose.position.z(), hpr.x(), hpr.y(), hpr.z()})
                out.cell(v);
            out.endRow();
        }
    }

private:
    std::vector<std::size_t> m_robots;
};

} // namespace

void PoseLogSettings::describe(Describe<PoseLogSettings>& d) {
    d.help("Where robots are: position and heading, pitch, roll of each.");
    d.field("Robot", &PoseLogSettings::robots, text(),
            "Robots to log: names, a Grid's name, or a pattern such as \"robot*\"; all by default.");
    describeLogSettings(d);
}

std::unique_ptr<RunLog> makePoseLog(const ComponentSpec& spec, const World& world, Diagnostics& diagnostics) {
    return std::make_unique<PoseLog>(chooseRobots(spec, world.experiment().robots, diagnostics));
}

} // namespace trundle
