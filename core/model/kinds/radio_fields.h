#pragma once
// Field tables of antennas and the radio medium.

#include <optional>
#include <string>
#include <vector>

#include <trundle/describe.h>

namespace trundle {

struct AntennaPatternFields {
    std::string model = "isotropic";
    std::optional<double> peakGain, beamWidth; ///< dBi; rad
    std::vector<double> azimuth, elevation;    ///< alternating angle and gain: deg, dBi, deg, dBi ...
    std::optional<std::string> file;
    static void describe(Describe<AntennaPatternFields>& d);
};

struct RadioMediumFields {
    std::string model = "ideal", mac = "none";
    double frequency = 2.45e9, exponent = 2, shadowing = 0, correlation = 2, permittivity = 15, wallLoss = 0;
    double noiseFloor = -98, implementationLoss = 3.5, captureMargin = 3, carrierSense = -77, offsets = 0, clockDrift = 0;
    bool packetErrors = false, collisions = false;
    static void describe(Describe<RadioMediumFields>& d);
};

} // namespace trundle
