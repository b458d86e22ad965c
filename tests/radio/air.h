#pragma once
// Helpers that set up radios in free space for the tests of the medium.

#include <memory>
#include <string>
#include <vector>

#include "radio/medium.h"

namespace air {

using namespace trundle;

inline RadioDefinition radioNamed(const std::string& path) {
    RadioDefinition d;
    d.path = path;
    d.rssiStep = 0;
    return d;
}

/// Opens a radio at a position.
inline RadioId open(Medium& medium, RadioDefinition definition, const Vec3& place, const Vec3& hpr = Vec3::Zero()) {
    const RadioId id = medium.open(std::move(definition));
    medium.place(id, {place, rotationFromHpr(hpr)});
    return id;
}
inline RadioId open(Medium& medium, const std::string& path, const Vec3& place) { return open(medium, radioNamed(path), place); }

inline bool send(Medium& medium, RadioId radio, std::size_t bytes = 10, std::uint32_t to = kBroadcastAddress, double power = 0) {
    return medium.send(radio, std::vector<std::uint8_t>(bytes, 0x55), to, power);
}

inline std::uint64_t count(const Medium& medium, ReceptionOutcome outcome) {
    return medium.outcomes()[static_cast<std::size_t>(outcome)];
}

/// Every expected reception has exactly one outcome.
inline bool isConserved(const Medium& medium) {
    std::uint64_t decided = 0;
    for (const std::uint64_t n : medium.outcomes()) decided += n;
    return decided + medium.inTheAir() == medium.expected();
}

} // namespace air
