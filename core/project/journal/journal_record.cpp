#include "project/journal/journal_record.h"

#include <array>

namespace trundle {

namespace {

constexpr std::size_t kMaxFields = 16, kNumberBytes = 4;

/// CRC-32 as in ISO 3309 (polynomial 0xEDB88320 reflected).
std::uint32_t checksum(std::string_view bytes) {
    static const auto table = [] {
        std::array<std::uint32_t, 256> t{};
        for (std::uint32_t i = 0; i < 256; ++i) {
            t[i] = i;
            for (int bit = 0; bit < 8; ++bit) t[i] = t[i] & 1 ? 0xEDB88320u ^ (t[i] >> 1) : t[i] >> 1;
        }
        return t;
    }();
    std::uint32_t sum = 0xFFFFFFFFu;
    for (const char byte : bytes) sum = table[(sum ^ static_cast<unsigned char>(byte)) & 0xFF] ^ (sum >> 8);
    return ~sum;
}

void putNumber(std::string& out, std::uint32_t number) {
    for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>(number >> shift & 0xFF);
}

std::optional<std::uint32_t> readNumber(std::string_view& bytes) {
    if (bytes.size() < 4) return std::nullopt;
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < 4; ++i) number |= std::uint32_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
    bytes.remove_prefix(4);
    return number;
}

} // namespace

std::string journalBytes(const JournalRecord& record) {
    const std::vector<std::string_view> fields(record.fields.begin(), record.fields.end());
    return journalBytes(static_cast<JournalRecord::Kind>(record.kind), fields);
}

std::string journalBytes(JournalRecord::Kind kind, std::span<const std::string_view> fields) {
    std::size_t size = 1;
    for (const std::string_view field : fields) size += kNumberBytes + field.size();
    std::string bytes;
    bytes.reserve(2 * kNumberBytes + size);
    putNumber(bytes, static_cast<std::uint32_t>(size));
    putNumber(bytes, 0); // the checksum
    bytes += static_cast<char>(kind);
    for (const std::string_view field : fields) {
        putNumber(bytes, static_cast<std::uint32_t>(field.size()));
        bytes += field;
    }
    std::string sum;
    putNumber(sum, checksum(std::string_view(bytes).substr(2 * kNumberBytes)));
    return bytes.replace(kNumberBytes, kNumberBytes, sum);
}

std::optional<JournalRecord> nextRecord(std::string_view& bytes) {
    const auto length = readNumber(bytes), sum = readNumber(bytes);
    if (!length || !sum || *length == 0 || *length > bytes.size()) return std::nullopt;
    std::string_view content = bytes.substr(0, *length);
    if (checksum(content) != *sum) return std::nullopt;
    bytes.remove_prefix(*length);
    JournalRecord record{content.front(), {}};
    content.remove_prefix(1);
    while (!content.empty()) {
        const auto size = readNumber(content);
        if (!size || *size > content.size() || record.fields.size() >= kMaxFields) return std::nullopt;
        record.fields.emplace_back(content.substr(0, *size));
        content.remove_prefix(*size);
    }
    return record;
}

} // namespace trundle
