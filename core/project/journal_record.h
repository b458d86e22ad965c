#pragma once
// The records of a journal as bytes. Private to core/project.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trundle {

inline constexpr std::string_view kJournalMark = "TRUNDLE JOURNAL 1\n";

/// Fourth field of a Begin record: an edit created the file. Journals of earlier versions have three fields.
inline constexpr std::string_view kCreatedMark = "created";

/// A letter that says what it is, and fields of any bytes.
struct JournalRecord {
    enum Kind : char { Head = 'H', Begin = 'B', Change = 'C', Forget = 'F' };
    char kind = Head;
    std::vector<std::string> fields;
};

/// Length, checksum, content.
[[nodiscard]] std::string journalBytes(const JournalRecord& record);
/// Takes the next record off the front; nothing at the end, or where the bytes are no whole record.
[[nodiscard]] std::optional<JournalRecord> nextRecord(std::string_view& bytes);

} // namespace trundle
