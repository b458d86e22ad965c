#include "editor/text/code/code_text.h"

#include <algorithm>

#include "base/utf8.h"

namespace trundle {

using Sci = QsciScintillaBase;

std::string_view CodeText::view() const {
    const auto length = static_cast<std::size_t>(size());
    const auto* text = static_cast<const char*>(m_edit.SendScintillaPtrResult(Sci::SCI_GETCHARACTERPOINTER));
    return {text ? text : "", text ? length : 0};
}

std::string CodeText::bytes() const {
    std::string all(kBom.substr(0, m_bom));
    all += view();
    return all;
}

bool CodeText::is(std::string_view bytes) const {
    const std::string_view bom = kBom.substr(0, m_bom);
    return bytes.starts_with(bom) && bytes.substr(bom.size()) == view();
}

std::string_view CodeText::hideBom(std::string_view bytes) {
    m_bom = bytes.starts_with(kBom) ? static_cast<std::uint32_t>(kBom.size()) : 0;
    return bytes.substr(m_bom);
}

long CodeText::position(std::uint32_t offset) const {
    const long place = offset > m_bom ? static_cast<long>(offset - m_bom) : 0;
    return std::min(place, size());
}

unsigned long CodeText::lineAt(std::uint32_t offset) const {
    return static_cast<unsigned long>(
        m_edit.SendScintilla(Sci::SCI_LINEFROMPOSITION, static_cast<unsigned long>(position(offset))));
}

TextRange CodeText::selection() const {
    return {offset(m_edit.SendScintilla(Sci::SCI_GETSELECTIONSTART)), offset(m_edit.SendScintilla(Sci::SCI_GETSELECTIONEND))};
}

} // namespace trundle
