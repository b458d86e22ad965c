#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "radio/medium.h"
#include "radio/pcap.h"
#include "run/logs/csv.h"
#include "run/logs/log.h"
#include "run/logs/log_choice.h"
#include "run/logs/log_settings.h"
#include "run/logs/radio_rows.h"

namespace trundle {
namespace {

/// The robots named by the log; an empty set means all.
std::set<std::string, std::less<>> robotsOf(const ComponentSpec& spec, const World& world, Diagnostics& diagnostics) {
    std::set<std::string, std::less<>> names;
    if (!spec.texts("Robot").empty())
        for (const std::size_t robot : chooseRobots(spec, world.experiment().robots, diagnostics))
            names.insert(world.experiment().robots[robot].name);
    return names;
}

class RadioChoice {
public:
    RadioChoice(const Medium& medium, const std::set<std::string, std::less<>>& robots) {
        for (RadioId id = 0; id < medium.radioCount(); ++id) {
            const std::string_view path = medium.radio(id).path;
            m_chosen.push_back(robots.empty() || robots.contains(path.substr(0, path.find('/'))));
        }
    }
    [[nodiscard]] bool has(RadioId id) const { return m_chosen[id]; }

private:
    std::vector<bool> m_chosen;
};

double rounded(double decibels) { return std::round(decibels * 1000) / 1000; }

class RadioLog final : public RunLog {
public:
    RadioLog(Medium& medium, RadioChoice robots) : m_medium(medium), m_robots(std::move(robots)), m_trace(medium.trace()) {}

    void header(std::string& csv) const override { addRadioHeader(csv); }

    void rows(const World&, double, std::string& csv) override { collected(csv); }
    void collected(std::string& csv) override {
        for (const FrameRecord& r : m_trace->records)
            if (m_robots.has(r.from) || m_robots.has(r.to)) addRadioRow(r, m_medium.radio(r.from), m_medium.radio(r.to), csv);
        m_trace->records.clear();
        m_trace->frames.clear();
    }

private:
    const Medium& m_medium;
    RadioChoice m_robots;
    std::shared_ptr<RadioTrace> m_trace;
};

bool isReceived(ReceptionOutcome outcome) {
    return outcome == ReceptionOutcome::Delivered || outcome == ReceptionOutcome::NotAddressed ||
           outcome == ReceptionOutcome::BufferFull || outcome == ReceptionOutcome::Duplicate;
}

/// Captures the frames as a sniffer next to every sender would: those that the chosen radios send or receive.
class PacketCapture final : public RunLog {
public:
    PacketCapture(Medium& medium, RadioChoice robots) : m_robots(std::move(robots)), m_trace(medium.trace()) {}

    void header(std::string& bytes) const override { beginPcap(bytes); }
    void rows(const World&, double, std::string& bytes) override { collected(bytes); }
    void collected(std::string& bytes) override {
        std::set<std::pair<RadioId, double>> received; // by sender and start: a radio sends one frame at a time
        for (const FrameRecord& r : m_trace->records)
            if (m_robots.has(r.to) && isReceived(r.outcome)) received.emplace(r.from, r.time);
        std::map<RadioId, AirFrame> open;
        const auto take = [&](AirFrame& frame) {
            if (m_robots.has(frame.from) || received.contains({frame.from, frame.time})) addToPcap(frame, bytes);
            else open[frame.from] = std::move(frame);
        };
        for (auto& [from, frame] : m_open) take(frame);
        for (AirFrame& frame : m_trace->frames) take(frame);
        m_open = std::move(open);
        m_trace->records.clear();
        m_trace->frames.clear();
    }

private:
    RadioChoice m_robots;
    std::shared_ptr<RadioTrace> m_trace;
    std::map<RadioId, AirFrame> m_open; ///< by sender: its last one, which may be received yet
};

class LinkMatrix final : public RunLog {
public:
    LinkMatrix(const Medium& medium, RadioChoice robots) : m_medium(medium), m_robots(std::move(robots)) {}

    void header(std::string& csv) const override {
        CsvWriter out(csv);
        for (const char* name : {"time [s]", "from", "to", "distance [m]", "send gain [dBi]", "receive gain [dBi]",
                                 "path loss [dB]", "shadowing [dB]", "wall loss [dB]", "received power [dBm]", "margin [dB]"})
            out.cell(name);
        out.endRow();
    }

    void rows(const World&, double time, std::string& csv) override {
        CsvWriter out(csv);
        for (RadioId from = 0; from < m_medium.radioCount(); ++from)
            for (RadioId to = 0; to < m_medium.radioCount(); ++to) {
                if (from == to || !m_robots.has(from) || !m_robots.has(to)) continue;
                if (m_medium.radio(from).channel != m_medium.radio(to).channel) continue;
                const LinkBudget link = m_medium.link(from, to);
                out.cell(time).cell(m_medium.radio(from).path).cell(m_medium.radio(to).path).cell(rounded(link.distance));
                out.cell(rounded(link.sendGain)).cell(rounded(link.receiveGain)).cell(rounded(link.pathLoss));
                out.cell(rounded(link.shadow)).cell(rounded(link.wallLoss)).cell(rounded(link.power));
                out.cell(rounded(link.power - m_medium.radio(to).minReceivePower)).endRow();
            }
    }

private:
    const Medium& m_medium;
    RadioChoice m_robots;
};

} // namespace

void RadioLogSettings::describe(Describe<RadioLogSettings>& d) {
    d.help("Every frame at every radio that it may reach: what was sent, what was lost where, what was read, and the outcome. "
           "Radios far out "
           "of range have no row.");
    d.field("Robot", &RadioLogSettings::robots, text(),
            "Frames from or to these robots only: names, a Grid's name, or a pattern such as \"robot*\".");
    d.field("Format", &RadioLogSettings::format, oneOf("csv|pcap"), "pcap: the frames sent, for Wireshark (IEEE 802.15.4).");
    describeLogSettings(d);
}

void LinkMatrixSettings::describe(Describe<LinkMatrixSettings>& d) {
    d.help("The link from each radio to each other, at the sender's full power, term by term.");
    d.field("Robot", &LinkMatrixSettings::robots, text(),
            "Radios of these robots only: names, a Grid's name, or a pattern such as \"robot*\"; all by default.");
    describeLogSettings(d);
}

std::unique_ptr<RunLog> makeRadioLog(const ComponentSpec& spec, const World& world, Diagnostics& diagnostics) {
    Medium* medium = world.medium();
    if (!medium) return nullptr;
    RadioChoice choice(*medium, robotsOf(spec, world, diagnostics));
    if (spec.text("Format") == "pcap") return std::make_unique<PacketCapture>(*medium, std::move(choice));
    return std::make_unique<RadioLog>(*medium, std::move(choice));
}

std::unique_ptr<RunLog> makeLinkMatrix(const ComponentSpec& spec, const World& world, Diagnostics& diagnostics) {
    const Medium* medium = world.medium();
    if (!medium) return nullptr;
    return std::make_unique<LinkMatrix>(*medium, RadioChoice(*medium, robotsOf(spec, world, diagnostics)));
}

} // namespace trundle
