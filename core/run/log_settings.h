#pragma once
// The fields of each kind of log, named once.

#include <string>
#include <vector>

#include "run/log.h"

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
struct SignalLogSettings : LogSettings {
    std::vector<std::string> signals;
    static void describe(Describe<SignalLogSettings>& d);
};

} // namespace trundle
