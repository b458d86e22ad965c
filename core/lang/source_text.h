#pragma once
// The bytes of one file and where its lines start.

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

    [[nodiscard]] const std::string& path() const { return m_path; } ///< as shown to the user
    [[nodiscard]] std::string_view bytes() const { return *m_bytes; }
    [[nodiscard]] std::string_view slice(TextRange range) const;
    [[nodiscard]] LineColumn position(std::uint32_t offset) const;
    /// The text of a 1-based line without its line end.
    [[nodiscard]] std::string_view line(std::uint32_t line) const;
    [[nodiscard]] std::uint32_t lineCount() const { return m_lines; }

private:
    /// The line and column of an offset, about one in each 4 KiB: any other is found from the last one before it.
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

/// The texts that SourceRanges of one load refer to. A value: copying copies pointers.
class SourceTable {
public:
    struct Entry {
        std::shared_ptr<const SourceText> text;
        SourceRange importedFrom; ///< the directive that first brought it in; unknown for the root
    };

    FileId add(std::shared_ptr<const SourceText> text, SourceRange importedFrom = {});
    /// A new version of a text already in the table (after an edit).
    void replace(FileId file, std::shared_ptr<const SourceText> text);
    [[nodiscard]] const Entry& operator[](FileId file) const { return m_entries[file]; }
    [[nodiscard]] std::size_t size() const { return m_entries.size(); }
    [[nodiscard]] std::string_view slice(const SourceRange& range) const;

private:
    std::vector<Entry> m_entries;
};

} // namespace trundle
