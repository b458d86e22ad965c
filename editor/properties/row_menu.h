#pragma once
#include <functional>

#include "editor/document/document.h"
#include "editor/properties/row.h"

class QMenu;

namespace trundle {

/// Callbacks of a row's menu, for the actions other than typing.
struct RowActions {
    std::function<void(const SourceRange&)> jump;
    std::function<void()> editAsText;
    std::function<void(const Status& status)> failed; ///< also called on success
    bool asText = false;                              ///< the row is edited as text
};

/// Adds the entries that apply to the row: go to source, reset, move into the config, copy the config, copy path or value.
void fillRowMenu(QMenu& menu, const Row& row, Document& document, const RowActions& actions);

} // namespace trundle
