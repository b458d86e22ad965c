// Format: https://www.tcpdump.org/manpages/pcap-savefile.5.txt
#include "radio/pcap.h"

#include <cmath>

namespace trundle {

namespace {

constexpr std::uint32_t kPcapMagic = 0xa1b2c3d4, kVersion = 2 | 4 << 16, kMaxBytes = 127, kIeee802154 = 195;

void putLittle(std::string& bytes, std::uint32_t value) {
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
}

} // namespace

void beginPcap(std::string& bytes) {
    for (const std::uint32_t word : {kPcapMagic, kVersion, 0u, 0u, kMaxBytes, kIeee802154}) putLittle(bytes, word);
}

void addToPcap(const AirFrame& frame, std::string& bytes) {
    const auto us = static_cast<std::uint64_t>(std::llround(frame.time * 1e6));
    const auto length = static_cast<std::uint32_t>(frame.bytes.size());
    putLittle(bytes, static_cast<std::uint32_t>(us / 1000000));
    putLittle(bytes, static_cast<std::uint32_t>(us % 1000000));
    putLittle(bytes, length);
    putLittle(bytes, length);
    bytes.append(frame.bytes.begin(), frame.bytes.end());
}

} // namespace trundle
