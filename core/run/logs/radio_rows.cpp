#include "run/logs/radio_rows.h"

#include <cmath>

#include "radio/ieee802154.h"
#include "run/logs/csv.h"

namespace trundle {
namespace {

double thousandths(double decibels) { return std::round(decibels * 1000) / 1000; }

} // namespace

void addRadioHeader(std::string& csv) {
    CsvWriter out(csv);
    for (const char* name : {"time [s]", "from", "to", "kind", "addressed to", "sequence", "bytes", "output power [dBm]",
                             "distance [m]", "send gain [dBi]", "receive gain [dBi]", "path loss [dB]", "shadowing [dB]",
                             "wall loss [dB]", "received power [dBm]", "RSSI [dBm]", "SINR [dB]", "LQI", "fate"})
        out.cell(name);
    out.endRow();
}

void addRadioRow(const FrameRecord& r, const RadioDefinition& from, const RadioDefinition& to, std::string& csv) {
    CsvWriter out(csv);
    out.cell(r.time).cell(from.path).cell(to.path).cell(r.ack ? "ack" : "data");
    if (r.address == kBroadcastAddress) out.cell("all");
    else out.cell(r.address);
    out.cell(r.sequence).cell(r.bytes).cell(thousandths(r.outputPower)).cell(thousandths(r.link.distance));
    out.cell(thousandths(r.link.sendGain)).cell(thousandths(r.link.receiveGain)).cell(thousandths(r.link.pathLoss));
    out.cell(thousandths(r.link.shadow)).cell(thousandths(r.link.wallLoss)).cell(thousandths(r.link.power));
    out.cell(r.rssi).cell(thousandths(r.sinr)).cell(r.lqi).cell(outcomeName(r.outcome)).endRow();
}

} // namespace trundle
