#pragma once
#include <string>

#include "radio/radio_trace.h"

namespace trundle {

/// A capture file of link type 195 (IEEE 802.15.4 with check sequence), for Wireshark: header, then one record per frame.
void beginPcap(std::string& bytes);
void addToPcap(const AirFrame& frame, std::string& bytes);

} // namespace trundle
