#include "run/csv.h"
#include "run/log.h"
#include "run/log_choice.h"
#include "run/log_settings.h"
#include "run/signal_columns.h"

namespace trundle {
namespace {

class SignalLog final : public Log {
public:
    explicit SignalLog(const std::vector<const SignalEntry*>& signals) {
        for (const SignalEntry* entry : signals) m_columns.emplace_back(*entry);
    }

    void header(std::string& csv) const override {
        CsvWriter out(csv);
        out.cell("time [s]");
        for (const SignalColumns& columns : m_columns)
            for (const std::string& name : columns.names()) out.cell(name);
        out.endRow();
    }

    void rows(const World& world, double time, std::string& csv) override {
        m_numbers.clear();
        for (const SignalColumns& columns : m_columns) columns.read(world.block().slots(), m_numbers);
        CsvWriter out(csv);
        out.cell(time);
        for (const double number : m_numbers) out.cell(number);
        out.endRow();
    }

private:
    std::vector<SignalColumns> m_columns;
    std::vector<double> m_numbers; // reused to avoid allocations
};

} // namespace

void SignalLogSettings::describe(Describe<SignalLogSettings>& d) {
    d.help("Any signals, one column each (a pose has six).");
    d.field("Signals", &SignalLogSettings::signals, text().counted(1, 100000).required(),
            "Paths such as robot0/leftEncoder/count, or patterns such as \"robot0/*\".");
    describeLogSettings(d);
}

std::unique_ptr<Log> makeSignalLog(const ComponentSpec& spec, const World& world, Diagnostics& diagnostics) {
    return std::make_unique<SignalLog>(chooseSignals(spec, world.layout(), diagnostics));
}

} // namespace trundle
