#include "radio/ieee802154.h"

#include <algorithm>
#include <cmath>

namespace trundle {

namespace {

constexpr std::uint16_t kNetwork = 0x22;

/// ITU-T CRC-16, least significant bit first.
std::uint16_t checkSequence(std::span<const std::uint8_t> bytes) {
    std::uint16_t crc = 0;
    for (const std::uint8_t byte : bytes) {
        crc = static_cast<std::uint16_t>(crc ^ byte);
        for (int i = 0; i < 8; ++i) crc = static_cast<std::uint16_t>(crc & 1 ? (crc >> 1) ^ 0x8408 : crc >> 1);
    }
    return crc;
}

void put16(std::vector<std::uint8_t>& bytes, std::uint32_t value) {
    bytes.push_back(static_cast<std::uint8_t>(value & 0xff));
    bytes.push_back(static_cast<std::uint8_t>((value >> 8) & 0xff));
}

} // namespace

double bitErrorRate(double sinrDb) {
    static constexpr double kChoose[17] = {1,     16,   120,  560,  1820, 4368, 8008, 11440, 12870,
                                           11440, 8008, 4368, 1820, 560,  120,  16,   1};
    if (sinrDb > 15) return 0; // below 1e-100
    const double ratio = std::pow(10, sinrDb / 10);
    double sum = 0;
    for (int k = 2; k <= 16; ++k) sum += (k % 2 ? -1 : 1) * kChoose[k] * std::exp(20 * ratio * (1.0 / k - 1));
    return std::clamp(8.0 / 15 / 16 * sum, 0.0, 0.5);
}

double receptionRate(double sinrDb, double bits) {
    const double errors = bitErrorRate(sinrDb);
    return errors > 0 ? std::exp(bits * std::log1p(-errors)) : 1;
}

std::int64_t airtimeUs(std::uint32_t mpduBytes, double bitRate) {
    return std::max<std::int64_t>(1, std::llround((6.0 + mpduBytes) * 8e6 / bitRate));
}

int linkQuality(double sinrDb) { return static_cast<int>(std::lround(std::clamp(50 + 6 * sinrDb, 40.0, 110.0))); }

std::vector<std::uint8_t> dataFrame(std::uint32_t from, std::uint32_t to, std::uint8_t sequence, bool wantsAck,
                                    std::span<const std::uint8_t> payload) {
    std::vector<std::uint8_t> bytes{static_cast<std::uint8_t>(wantsAck ? 0x61 : 0x41), 0x88, sequence};
    put16(bytes, kNetwork);
    put16(bytes, to);
    put16(bytes, from);
    bytes.insert(bytes.end(), payload.begin(), payload.end());
    put16(bytes, checkSequence(bytes));
    return bytes;
}

std::vector<std::uint8_t> ackFrame(std::uint8_t sequence) {
    std::vector<std::uint8_t> bytes{0x02, 0x00, sequence};
    put16(bytes, checkSequence(bytes));
    return bytes;
}

} // namespace trundle
