// A mote of a sensor network. The target floods the network with a number; every mote keeps its best route to the target from the
// newest floods and broadcasts it to its neighbours: a pseudo-gradient towards the target (after Deshpande, Grant and Henderson,
// IEEE Systems Journal 8(1), 2014).
#include <trundle/controller.h>

#include "beacon.h"

namespace {

constexpr int kTimeout = 3; ///< floods without an update of its route before it accepts a worse one

struct Mote : trundle::Controller {
    double period = 0.1, floodPeriod = 2, power = 0, goodRssi = -75;
    bool target = false;
    std::string radioName = "radio";

    static void describe(trundle::Describe<Mote>& d) {
        d.help("Sends beacons with the distance to the target mote, from hops and signal strengths.");
        d.field("Target", &Mote::target, trundle::flag(), "It is the target itself.");
        d.field("Period", &Mote::period, trundle::seconds().within(0.01, 1000), "Mean time between its beacons.");
        d.field("FloodPeriod", &Mote::floodPeriod, trundle::seconds().within(0.1, 1000), "Between two floods of the target.");
        d.field("Power", &Mote::power, trundle::decibelMilliwatts().within(-100, 100), "It sends with.");
        d.field("GoodRssi", &Mote::goodRssi, trundle::decibelMilliwatts().within(-150, 50),
                "A hop with more costs no more than one hop.");
        d.field("Radio", &Mote::radioName, trundle::needs("Transceiver"), "Its Transceiver.");
        d.output("hops", &Mote::hops, "", "To the target; -1: no route is known.");
        d.output("cost", &Mote::cost, "",
                 "Of its route to the target: 10 for a good hop, more for a weak one; -1: no route is known.");
    }

    void setup(trundle::RobotPorts& robot) override {
        radio = robot.radio(radioName);
        learn({});
        nextBeacon = period * random();
    }

    void update(trundle::Seconds) override {
        while (const auto packet = radio.receive())
            if (const auto beacon = Beacon::from(packet->bytes)) heard(*beacon, packet->rssi);
        if (target && time() >= nextFlood) {
            nextFlood += floodPeriod;
            learn({static_cast<std::uint16_t>(known.flood + 1), 0, 0});
        }
        if (time() < nextBeacon) return;
        nextBeacon = time() + period * random(0.5, 1.5); // random, so that neighbours do not collide repeatedly
        radio.send(known.bytes(), power);
    }

private:
    /// Handles a neighbour's route to the target and the RSSI of the hop to that neighbour.
    void heard(const Beacon& beacon, double rssi) {
        if (target || !beacon.knowsTarget()) return;
        const double hop = 10 + std::max(0.0, goodRssi - rssi);
        const double sum = beacon.cost + hop;
        if (sum >= Beacon::kUnknown || beacon.hops >= 254) return;
        if (known.knowsTarget()) {
            const auto ahead = static_cast<std::int16_t>(beacon.flood - known.flood); // the number wraps around
            if (ahead < 0 || (ahead == 0 && sum >= known.cost)) return;
            if (ahead < kTimeout && sum > known.cost) return;
        }
        learn({beacon.flood, static_cast<std::uint8_t>(beacon.hops + 1), static_cast<std::uint16_t>(sum)});
    }

    void learn(const Beacon& way) {
        known = way;
        hops.set(known.knowsTarget() ? known.hops : -1);
        cost.set(known.knowsTarget() ? known.cost : -1);
    }

    trundle::RadioPort radio;
    trundle::OutputSlot<int> hops, cost;
    Beacon known;
    double nextBeacon = 0, nextFlood = 0;
};

} // namespace

TRUNDLE_MODULE(registry) { registry.controller<Mote>("Mote"); }
