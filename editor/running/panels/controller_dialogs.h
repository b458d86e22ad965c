#pragma once
#include <vector>

#include <QString>

#include "project/edits/controllers.h"

class QWidget;

namespace trundle {

/// Asks whether modules of a folder may run, and explains the risk.
[[nodiscard]] bool askForTrust(const QString& library, const QString& folder, QWidget* parent);
/// Asks for a controller. Returns its index; -1: none.
[[nodiscard]] int chooseController(const std::vector<ControllerChoice>& choices, const std::vector<std::string>& robots,
                                   QWidget* parent);

} // namespace trundle
