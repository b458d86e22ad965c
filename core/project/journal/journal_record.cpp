#include "project/journal/journal_record.h"

#include <array>

namespace trundle {

namespace {

constexpr std::size_t kMaxFields = 16, kNumberBytes = 4;

/// CRC-32 as in ISO 3309 (polynomial 0xEDB88320 reflected). `sum`: of the bytes before.
std::uint32_t checksum(std::string_view bytes, std::uint32_t sum = 0) {
    static const auto table = [] {
        std::array<std::uint32_t, 256> t{};
        for (std::uint32_t i = 0; i < 256; ++i) {
            t[i] = i;
            for (int bit = 0; bit < 8; ++bit) t[i] = t[i] & 1 ? 0xEDB88320u ^ (t[i] >> 1) : t[i] >> 1;
        }
        return t;
    }();
    sum = ~sum;
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
    const JournalPieces pieces(static_cast<JournalRecord::Kind>(record.kind), fields);
    std::string bytes;
    bytes.reserve(pieces.size());
    for (const std::string_view piece : pieces.all()) bytes += piece;
    return bytes;
}

JournalPieces::JournalPieces(JournalRecord::Kind kind, std::span<const std::string_view> fields) {
    m_heads.emplace_back(1, static_cast<char>(kind));
    std::size_t size = 1;
    for (const std::string_view field : fields) {
        if (size > 1) m_heads.emplace_back();
        putNumber(m_heads.back(), static_cast<std::uint32_t>(field.size()));
        size += kNumberBytes + field.size();
    }
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i < m_heads.size(); ++i) {
        sum = checksum(m_heads[i], sum);
        if (i < fields.size()) sum = checksum(fields[i], sum);
    }
    std::string start;
    putNumber(start, static_cast<std::uint32_t>(size));
    putNumber(start, sum);
    m_heads[0].insert(0, start);
    for (std::size_t i = 0; i < m_heads.size(); ++i) {
        m_pieces.emplace_back(m_heads[i]);
        if (i < fields.size()) m_pieces.push_back(fields[i]);
    }
}

std::size_t JournalPieces::size() const {
    std::size_t size = 0;
    for (const std::string_view piece : m_pieces) size += piece.size();
    return size;
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
