#pragma once
#include <QWidget>

#include "editor/document/structure_edits.h"

namespace trundle {

/// Asks whether a config that others use too is to be changed for all of them. Returns at once; the answer comes with the click.
void askAboutSharedConfig(QWidget* parent, const ShareQuestion& question, const StructureEdits::Answer& answer);

} // namespace trundle
