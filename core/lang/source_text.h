#pragma once
// The text of one file and the positions of its lines; the table of all texts of one load.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/source_range.h"

namespace trundle {

/// 1-based line and column. Columns count code points; a tab counts 1, a BOM 0, an invalid byte 1.
struct LineColumn {
    std::uint32_t line = 1;
    std::uint32_t column = 1;
};

/// Immutable. Lines end at LF, CR LF or a lone CR.
class SourceText {
public:
    SourceText(std::string path, std::string bytes);
    SourceText(std::string path, std::shared_ptr<const std::string> bytes);

    [[nodiscard]] const std::string& path() const { return m_path; } ///< as displayed to the user
    [[nodiscard]] std::string_view bytes() const { return *m_bytes; }
    [[nodiscard]] const std::shared_ptr<const std::string>& sharedBytes() const { return m_bytes; }
    [[nodiscard]] std::string_view slice(TextRange range) const;
    [[nodiscard]] LineColumn position(std::uint32_t offset) const;
    /// The text of a 1-based line without its line end.
    [[nodiscard]] std::string_view line(std::uint32_t line) const;
    [[nodiscard]] std::uint32_t lineCount() const { return m_lines; }

private:
    /// Line and column of an offset, stored about every 4 KiB; other positions are found by scanning from the mark before.
    struct Mark {
        std::uint32_t offset = 0;
        LineColumn place;
    };
    [[nodiscard]] const Mark& markBefore(std::uint32_t offset) const;
    void step(Mark& mark) const;

    std::string m_path;
    std::shared_ptr<const std::string> m_bytes;
    std::vector<Mark> m_marks;
    std::uint32_t m_lines = 1;
};

/// The texts that the SourceRanges of one load refer to. A value type; copies share the texts.
class SourceTable {
public:
    struct Entry {
        std::shared_ptr<const SourceText> text;
        SourceRange importedFrom; ///< the directive that first imported it; unknown for the root
    };

    FileId add(std::shared_ptr<const SourceText> text, SourceRange importedFrom = {});
    /// Replaces a text in the table by a new version (after an edit).
    void replace(FileId file, std::shared_ptr<const SourceText> text);
    [[nodiscard]] const Entry& operator[](FileId file) const { return m_entries[file]; }
    [[nodiscard]] std::size_t size() const { return m_entries.size(); }
    [[nodiscard]] std::string_view slice(const SourceRange& range) const;

private:
    std::vector<Entry> m_entries;
};

} // namespace trundle
