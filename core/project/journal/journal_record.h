#pragma once
// Binary format of journal records. Private to core/project.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trundle {

inline constexpr std::string_view kJournalMark = "TRUNDLE JOURNAL 1\n";

/// Fourth field of a Begin record: the file was created by an edit. Journals of earlier versions have three fields.
inline constexpr std::string_view kCreatedMark = "created";

/// A letter for the type, and fields of any bytes.
struct JournalRecord {
    enum Kind : char { Head = 'H', Begin = 'B', Change = 'C', Forget = 'F' };
    char kind = Head;
    std::vector<std::string> fields;
};

/// Encodes a record: length, checksum, content.
[[nodiscard]] std::string journalBytes(const JournalRecord& record);
/// The same in pieces, for fields that may be large: they are not copied and must outlive this object.
class JournalPieces {
public:
    JournalPieces(JournalRecord::Kind kind, std::span<const std::string_view> fields);
    JournalPieces(const JournalPieces&) = delete;
    JournalPieces& operator=(const JournalPieces&) = delete;
    [[nodiscard]] std::span<const std::string_view> all() const { return m_pieces; }
    [[nodiscard]] std::size_t size() const; ///< bytes of all

private:
    std::vector<std::string> m_heads; ///< what precedes each field
    std::vector<std::string_view> m_pieces;
};
/// Removes the next record from the front of `bytes`; nothing at the end, or if it is not a complete record.
[[nodiscard]] std::optional<JournalRecord> nextRecord(std::string_view& bytes);

} // namespace trundle
