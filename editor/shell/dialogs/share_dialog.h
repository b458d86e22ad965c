#pragma once
#include <QWidget>

#include "editor/document/structure_edits.h"

namespace trundle {

/// Asks whether a config with several users is changed for all of them or copied. Returns at once; calls the answer when a
/// button is clicked.
void askAboutSharedConfig(QWidget* parent, const ShareQuestion& question, const StructureEdits::ShareAnswer& answer);

} // namespace trundle
