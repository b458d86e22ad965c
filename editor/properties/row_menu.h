#pragma once
#include <functional>

#include "editor/document/document.h"
#include "editor/properties/row.h"

class QMenu;

namespace trundle {

/// What can be done with a row beside typing in it.
struct RowDeeds {
    std::function<void(const SourceRange&)> jump;
    std::function<void()> editAsText;
    std::function<void(const Status& status)> failed; ///< also where all went well
    bool asText = false;                              ///< it is edited as text now
};

/// Entries that mean something for the row as it stands: go there, reset, push into the config, pull a copy, copy path or value.
void fillRowMenu(QMenu& menu, const Row& row, Document& document, const RowDeeds& deeds);

} // namespace trundle
