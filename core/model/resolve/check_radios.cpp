// Checks Transceivers before a run. They are ordinary devices, so their kind may not be registered.
#include <algorithm>
#include <map>
#include <set>

#include "model/resolve/resolve_steps.h"
#include "schema/value_words.h"

namespace trundle {

namespace {

constexpr const char* kTransceiver = "Transceiver";

std::vector<double> numbersOf(const ComponentSpec& radio, std::string_view key) {
    const ResolvedValue* value = radio.find(key);
    return value ? value->value.numbers : std::vector<double>();
}

SourceRange placeOf(const ComponentSpec& radio, std::string_view key) {
    const ResolvedValue* value = radio.find(key);
    return value && value->range.known() ? value->range : radio.nameRange;
}

/// Reports each source range once: robots share configs, and configs share files.
class RadioChecker {
public:
    explicit RadioChecker(ResolveContext& context) : m_context(context) {}

    void check(const RobotSpec& robot, const ComponentSpec& radio) {
        checkLevels(radio);
        checkWindow(radio);
        checkAddress(robot, radio);
    }

private:
    bool fresh(SourceRange place) { return m_reported.insert(place).second; }

    void checkLevels(const ComponentSpec& radio) {
        const std::vector<double> levels = numbersOf(radio, "PowerLevels"), currents = numbersOf(radio, "TransmitCurrent");
        checkLimit(radio, levels);
        if (currents.size() < 2 || currents.size() == levels.size()) return;
        if (const SourceRange place = placeOf(radio, "TransmitCurrent"); fresh(place))
            m_context.diagnostics.error(Code::WrongCount, place,
                                        "TransmitCurrent has " + std::to_string(currents.size()) + " values for " +
                                            std::to_string(levels.size()) +
                                            " PowerLevels: it takes one, or one for each of them");
    }

    /// A radio needs a level at or below MaxOutputPower; what is above it is never used.
    void checkLimit(const ComponentSpec& radio, const std::vector<double>& levels) {
        const double most = radio.number("MaxOutputPower");
        const auto tooHigh = std::ranges::find_if(levels, [most](double level) { return level > most; });
        if (tooHigh == levels.end()) return;
        const double lowest = std::ranges::min(levels);
        const ResolvedValue* limit = radio.find("MaxOutputPower");
        const bool limitGiven = limit && limit->origin != Origin::Default;
        const SourceRange place = placeOf(radio, lowest > most && limitGiven ? "MaxOutputPower" : "PowerLevels");
        if (!fresh(place)) return;
        if (lowest > most)
            m_context.diagnostics.error(Code::OutOfRange, place,
                                        "MaxOutputPower is " + numberText(most) + " dBm, but the lowest of PowerLevels is " +
                                            numberText(lowest) + " dBm: it has no level to send with");
        else
            m_context.diagnostics.warning(Code::OutOfRange, place,
                                          "PowerLevels has " + numberText(*tooHigh) + " dBm, but MaxOutputPower is " +
                                              numberText(most) + " dBm: it never sends with that");
    }

    void checkWindow(const ComponentSpec& radio) {
        const double least = radio.number("MinReceivePower"), most = radio.number("MaxReceivePower");
        if (least < most) return;
        const ResolvedValue* low = radio.find("MinReceivePower");
        const bool lowGiven = low && low->origin != Origin::Default;
        if (const SourceRange place = placeOf(radio, lowGiven ? "MinReceivePower" : "MaxReceivePower"); fresh(place))
            m_context.diagnostics.warning(Code::OutOfRange, place,
                                          "MinReceivePower is " + numberText(least) + " dBm and MaxReceivePower " +
                                              numberText(most) + " dBm: every RSSI would be the same");
    }

    void checkAddress(const RobotSpec& robot, const ComponentSpec& radio) {
        const double address = radio.number("Address");
        if (address == 0) return;
        const auto [first, isNew] = m_addresses.try_emplace({radio.number("Channel"), address}, &robot, &radio);
        if (isNew) return;
        const SourceRange place = placeOf(radio, "Address");
        if (!fresh(place)) return;
        const auto& [other, otherRadio] = first->second;
        m_context.diagnostics
            .warning(Code::DuplicateName, place,
                     robot.name + " and " + other->name + " both have a radio with the address " + numberText(address) +
                         ": packets for it reach both")
            .notes.emplace_back("the other one", placeOf(*otherRadio, "Address"));
    }

    ResolveContext& m_context;
    std::set<SourceRange> m_reported;
    std::map<std::pair<double, double>, std::pair<const RobotSpec*, const ComponentSpec*>> m_addresses; ///< by (channel, address)
};

} // namespace

void checkRadios(ResolveContext& context) {
    RadioChecker checker(context);
    for (const RobotSpec& robot : context.out.robots)
        for (const ComponentSpec& device : robot.config->devices)
            if (device.kind == kTransceiver) checker.check(robot, device);
}

} // namespace trundle
