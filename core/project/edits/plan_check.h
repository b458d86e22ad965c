#pragma once
// Checks that names still mean something after an edit. Private to core/project.

#include "base/result.h"
#include "project/edits/plans.h"

namespace trundle {

/// Fails, with the first error that the edited texts would have, if a name would lead nowhere or to something of the wrong kind,
/// or if it would be there twice. Not checked: edits that add an import or a module, whose content is not known here, and texts that
/// have such errors already.
[[nodiscard]] Status checkNames(const LoadedProject& loaded, const FileEdits& edits);

} // namespace trundle
