#pragma once
// Edits of single values, from the window to the text: a target and a parsed value.

#include <vector>

#include "lang/parsed_value.h"
#include "model/dotted_path.h"
#include "project/edits/plans.h"

namespace trundle {

/// A value to set: the property ("robot0.leftMotor.Resistance", "Tick") and its new value ("3", "12 cm").
struct ValueEdit {
    DottedPath path;
    ParsedValue value;
};

/// An existing value is replaced, otherwise an assignment is added to its block. Fails if one is no value or its path leads nowhere;
/// whether the property takes the value is known when the edited texts are loaded, see ChangeSet::valueErrors().
[[nodiscard]] Result<FileEdits> editsForValues(const LoadedProject& loaded, const std::vector<ValueEdit>& values);

} // namespace trundle
