#pragma once
#include <vector>

#include "editor/running/controller_edits.h"

class QWidget;

namespace trundle {

/// Whether modules of a folder may run. Says what that means.
[[nodiscard]] bool askForTrust(const QString& library, const QString& folder, QWidget* parent);
/// Index of the chosen controller; -1: none.
[[nodiscard]] int chooseController(const std::vector<ControllerChoice>& choices, const std::vector<std::string>& robots,
                                   QWidget* parent);

} // namespace trundle
