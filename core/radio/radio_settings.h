#pragma once
// Settings of the medium (RadioMedium) and of one radio (Transceiver), read from the text. dB, dBm, m, s, Hz, A, V.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "radio/antenna_pattern.h"

namespace trundle {

enum class PropagationModel { Ideal, TwoRay, LogDistance };

struct MediumSettings {
    PropagationModel model = PropagationModel::Ideal;
    bool csma = false;
    double frequency = 2.45e9;
    double exponent = 2;       ///< for LogDistance
    double shadowing = 0;      ///< dB, standard deviation
    double correlation = 2;    ///< m, correlation distance of the shadowing
    double permittivity = 15;  ///< of the ground, for TwoRay; 0: total reflection
    double wallLoss = 0;       ///< dB for each solid between the antennas
    double noiseFloor = -98;   ///< dBm
    bool packetErrors = false; ///< use bit error rates (IEEE 802.15.4) instead of a sharp threshold
    double implementationLoss = 3.5;
    bool collisions = false;   ///< overlapping frames disturb each other, and a receiver locks on to one of them
    double captureMargin = 3;  ///< dB over all others that a frame needs to survive, if packetErrors is off
    double carrierSense = -77; ///< dBm
    double offsets = 0;        ///< dB, standard deviation of each radio's output power and RSSI reading
    double clockDrift = 0;     ///< ppm, standard deviation of each radio's clock
    std::uint64_t seed = 1;
};

struct RadioDefinition {
    std::string path; ///< "robot0/radio"
    double maxOutputPower = 0, minReceivePower = -94, maxReceivePower = 0;
    double rssiStep = 1; ///< dB; 0: no rounding
    std::uint32_t bufferLimit = 16, channel = 26;
    std::uint32_t address = 0; ///< 0: the next free address
    double bitRate = 250000;
    std::shared_ptr<const AntennaPattern> antenna; ///< nullptr: isotropic
    std::vector<double> powerLevels;               ///< dBm; empty: continuous
    std::vector<double> transmitCurrents;          ///< A, one per level, or one for all
    double receiveCurrent = 0, supply = 3;
};

} // namespace trundle
