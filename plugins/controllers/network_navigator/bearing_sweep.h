#pragma once
#include "listener.h"

/// Turns once around and prints the bearing of each sender it receives.
struct BearingSweep : Listener {
    std::string samplesName = "samples.csv", fileName = "bearings.csv";

    static void describe(trundle::Describe<BearingSweep>& d) {
        d.help("Turns once on the spot and finds the bearing of each sender from the peak of its RSSI.");
        d.field("File", &BearingSweep::fileName, trundle::text(), "A line for each sender, in the log folder.");
        d.field("Samples", &BearingSweep::samplesName, trundle::text(), "A line for each packet, in the log folder.");
        describeListener(d);
    }

    void setup(trundle::RobotPorts& robot) override { bindListener(robot); }

    void update(trundle::Seconds) override {
        if (done) return;
        if (!started) {
            started = true;
            samples = openLog(samplesName);
            samples.write("sender,heading [deg],RSSI [dBm]\n");
            beginSweep();
        }
        listen([this](const trundle::Packet& packet, double heading) {
            sweep.add(packet.from, heading, packet.rssi);
            samples.write(std::to_string(packet.from) + ',' + std::to_string(heading / kDegree) + ',' +
                          std::to_string(packet.rssi) + '\n');
        });
        if (drive.done()) report();
    }

private:
    void report() {
        done = true;
        trundle::Log log = openLog(fileName);
        log.write("sender,packets,bearing [deg],RSSI [dBm]\n");
        for (const auto& [sender, heard] : sweep.samples()) {
            const auto bearing = sweep.bearing(sender);
            if (!bearing) continue;
            log.write(std::to_string(sender) + ',' + std::to_string(heard.size()) + ',' +
                      std::to_string(bearing->heading / kDegree) + ',' + std::to_string(bearing->rssi) + '\n');
            print("sender ", sender, " is at ", bearing->heading / kDegree, " deg, ", bearing->rssi, " dBm, from ", heard.size(),
                  " packets");
        }
    }

    trundle::Log samples;
    bool started = false, done = false;
};
