#include "editor/document/document.h"
#include "editor/document/structure_edits.h"

namespace trundle {

StructureEdits& Document::structure() {
    if (!m_structure) m_structure = std::make_shared<StructureEdits>(*this);
    return *m_structure;
}

} // namespace trundle
