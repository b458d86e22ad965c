#include "run/logs/csv.h"
#include "run/logs/log.h"
#include "run/logs/log_choice.h"
#include "run/logs/log_settings.h"

namespace trundle {
namespace {

class EnergyLog final : public RunLog {
public:
    explicit EnergyLog(std::vector<std::size_t> robots) : m_robots(std::move(robots)) {}

    void header(std::string& csv) const override {
        CsvWriter out(csv);
        for (const char* name : {"time [s]", "robot", "kinetic [J]", "potential [J]", "total [J]"}) out.cell(name);
        out.endRow();
    }

    void rows(const World& world, double time, std::string& csv) override {
        CsvWriter out(csv);
        for (const std::size_t robot : m_robots) {
            if (hasEnded(world, robot)) continue;
            const RobotEnergy energy = world.robotEnergy(robot);
            out.cell(time).cell(world.experiment().robots[robot].name);
            out.cell(energy.kinetic).cell(energy.potential).cell(energy.kinetic + energy.potential);
            out.endRow();
        }
    }

private:
    std::vector<std::size_t> m_robots;
};

} // namespace

void EnergyLogSettings::describe(Describe<EnergyLogSettings>& d) {
    d.help("Kinetic and potential energy of robots.");
    d.field("Robot", &EnergyLogSettings::robots, text(),
            "Robots to log: names, a Grid's name, or a pattern such as \"robot*\"; all by default.");
    describeLogSettings(d);
}

std::unique_ptr<RunLog> makeEnergyLog(const ComponentSpec& spec, const World& world, Diagnostics& diagnostics) {
    return std::make_unique<EnergyLog>(chooseRobots(spec, world.experiment().robots, diagnostics));
}

} // namespace trundle
