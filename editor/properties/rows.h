#pragma once
// The rows of a selection, from the schema of what is selected.

#include <memory>
#include <string>
#include <vector>

#include "editor/document/document.h"
#include "editor/properties/object_values.h"
#include "editor/properties/row.h"

namespace trundle {

class RunSession;

using Objects = std::vector<std::unique_ptr<ObjectValues>>;

/// Those of the paths that name something; the experiment where no path is given.
[[nodiscard]] Objects objectsAt(const std::shared_ptr<const Loaded>& loaded, const std::vector<std::string>& paths);
/// Rows that all of the objects have, in the order of the first. `session` may be missing.
[[nodiscard]] std::vector<Row> rowsOf(const Objects& objects, Document& document, const RunSession* session);

/// Moves an override into its config, or into the copy of it that the user chooses.
Status pushOverride(Document& document, const std::string& propertyPath);

/// "leftMotor.Resistance" of "robot0.leftMotor.Resistance": how edits are named.
[[nodiscard]] QString shortName(const std::string& path);

} // namespace trundle
