#pragma once
// Builds the property rows of a selection from the schema.

#include <memory>
#include <string>
#include <vector>

#include "editor/document/document.h"
#include "editor/properties/row.h"
#include "project/objects/object_values.h"

namespace trundle {

class RunSession;

using Objects = std::vector<std::unique_ptr<ObjectValues>>;

/// The objects of those paths that exist; the experiment if there are no paths.
[[nodiscard]] Objects objectsAt(const std::shared_ptr<const LoadedProject>& loaded, const std::vector<std::string>& paths);
/// The rows that all objects have in common, in the order of the first. `session` may be null.
[[nodiscard]] std::vector<Row> rowsOf(const Objects& objects, Document& document, const RunSession* session);

/// Moves an override into its config, or into a copy of it if the user chooses so.
Status pushOverride(Document& document, const std::string& propertyPath);
/// Writes the value of the config as an override. A Part in a config that came with Trundle gets it in a copy of the config.
Status pullOverride(Document& document, const std::string& propertyPath);

/// Whether the value can be taken out of the text: it has one here, and does without.
[[nodiscard]] bool canReset(const Row& row);

/// The name of a value in edits: "leftMotor.Resistance" for "robot0.leftMotor.Resistance".
[[nodiscard]] QString shortName(const std::string& path);

} // namespace trundle
