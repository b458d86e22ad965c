#pragma once
// Field tables of the kinds of logs.

#include <array>
#include <string>
#include <vector>

#include "run/logs/log.h"

namespace trundle {

struct PoseLogSettings : LogSettings {
    std::vector<std::string> robots;
    static void describe(Describe<PoseLogSettings>& d);
};
struct EnergyLogSettings : LogSettings {
    std::vector<std::string> robots;
    static void describe(Describe<EnergyLogSettings>& d);
};
struct ContactLogSettings : LogSettings {
    std::vector<std::string> robots;
    static void describe(Describe<ContactLogSettings>& d);
};
struct FrameLogSettings : LogSettings {
    std::optional<std::string> camera, view;
    std::string format = "jpg";
    std::array<double, 2> size{640, 480};
    static void describe(Describe<FrameLogSettings>& d);
};
struct SignalLogSettings : LogSettings {
    std::vector<std::string> signals;
    static void describe(Describe<SignalLogSettings>& d);
};

struct RadioLogSettings : LogSettings {
    std::vector<std::string> robots;
    std::string format = "csv";
    static void describe(Describe<RadioLogSettings>& d);
};
struct LinkMatrixSettings : LogSettings {
    LinkMatrixSettings() { interval = 1; }
    std::vector<std::string> robots;
    static void describe(Describe<LinkMatrixSettings>& d);
};

} // namespace trundle
