#include <algorithm>

#include "run/logs/csv.h"
#include "run/logs/log.h"
#include "run/logs/log_choice.h"
#include "run/logs/log_settings.h"
#include "run/logs/signal_columns.h"

namespace trundle {
namespace {

class SignalLog final : public RunLog {
public:
    explicit SignalLog(const std::vector<SignalEntry>& signals) {
        for (const SignalEntry& entry : signals) {
            m_columns.emplace_back(entry);
            m_robots.push_back(entry.path.substr(0, entry.path.find('/')));
        }
    }

    void header(std::string& csv) const override {
        CsvWriter out(csv);
        out.cell("time [s]");
        for (const SignalColumns& columns : m_columns)
            for (const std::string& name : columns.names()) out.cell(name);
        out.endRow();
    }

    void rows(const World& world, double time, std::string& csv) override {
        CsvWriter out(csv);
        out.cell(time);
        for (std::size_t i = 0; i < m_columns.size(); ++i) {
            m_numbers.clear();
            m_columns[i].read(world.block().slots(), m_numbers);
            const bool ended = hasEnded(world, m_robots[i]);
            for (const double number : m_numbers) ended ? out.cell("") : out.cell(number);
        }
        out.endRow();
    }

private:
    [[nodiscard]] static bool hasEnded(const World& world, const std::string& robot) {
        const auto isRobot = [&](const RobotEnd& end) { return world.experiment().robots[end.robot].name == robot; };
        return std::ranges::any_of(world.robotFaults().ends, isRobot);
    }

    std::vector<SignalColumns> m_columns;
    std::vector<std::string> m_robots; ///< whose signals they are
    std::vector<double> m_numbers;     // reused to avoid allocations
};

} // namespace

void SignalLogSettings::describe(Describe<SignalLogSettings>& d) {
    d.help("Any signals, one column each (a pose has six).");
    d.field("Signals", &SignalLogSettings::signals, text().counted(1, 100000).required(),
            "Paths such as robot0/leftEncoder/count, or patterns such as \"robot0/*\".");
    describeLogSettings(d);
}

std::unique_ptr<RunLog> makeSignalLog(const ComponentSpec& spec, const World& world, Diagnostics& diagnostics) {
    return std::make_unique<SignalLog>(chooseSignals(spec, world.layout(), diagnostics));
}

} // namespace trundle
