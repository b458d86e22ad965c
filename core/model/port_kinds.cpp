#include "model/port_kinds.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace trundle {

namespace {

/// A port of the first kind also fits devices of the second, whose signals are the same.
constexpr std::pair<std::string_view, std::string_view> kSameSignals[] = {{"DifferentialDrive", "SkidDrive"},
                                                                          {"DifferentialDrive", "TrackDrive"}};

} // namespace

bool portFits(std::string_view port, std::string_view device) {
    return port.empty() || port == device || std::ranges::find(kSameSignals, std::pair(port, device)) != std::end(kSameSignals);
}

} // namespace trundle
