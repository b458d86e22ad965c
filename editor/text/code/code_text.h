#pragma once
// The bytes in the editor widget. A BOM is hidden: offsets are byte offsets in the file and count it, positions are the widget's and
// do not.

#include <cstdint>
#include <string>
#include <string_view>

#include "base/source_range.h"
#include "editor/text/code/qscintilla.h"

namespace trundle {

class CodeText {
public:
    /// `edit` must outlive this object.
    explicit CodeText(QsciScintilla& edit) : m_edit(edit) {}

    [[nodiscard]] std::string bytes() const;
    [[nodiscard]] bool is(std::string_view bytes) const; ///< whether bytes() are these
    [[nodiscard]] std::string_view view() const;         ///< without the BOM; valid until the next change
    /// Remembers whether a text begins with a BOM, and returns what follows it.
    [[nodiscard]] std::string_view hideBom(std::string_view bytes);

    [[nodiscard]] long size() const { return m_edit.SendScintilla(QsciScintillaBase::SCI_GETLENGTH); }
    [[nodiscard]] long position(std::uint32_t offset) const; ///< inside the text
    [[nodiscard]] std::uint32_t offset(long position) const { return static_cast<std::uint32_t>(position) + m_bom; }
    [[nodiscard]] unsigned long lineAt(std::uint32_t offset) const;

    [[nodiscard]] long caret() const { return m_edit.SendScintilla(QsciScintillaBase::SCI_GETCURRENTPOS); }
    [[nodiscard]] long anchor() const { return m_edit.SendScintilla(QsciScintillaBase::SCI_GETANCHOR); }
    [[nodiscard]] TextRange selection() const; ///< in offsets

private:
    QsciScintilla& m_edit;
    std::uint32_t m_bom = 0; ///< its length in bytes
};

} // namespace trundle
