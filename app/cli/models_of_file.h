#pragma once
// The robot models of a file by themselves, for `check --model`.

#include <memory>
#include <string>

#include "app/application.h"

namespace trundle {

struct OpenedModels {
    std::shared_ptr<const LoadedProject> loaded;
    /// The file with the models; past the last one if it has an experiment too, which may use its definitions.
    FileId definitions = 0;
};

/// The robot models of a file, one beside the other on a plain floor; the file itself if it has none. Each has the height and the HPR of
/// the first robot that is made from it, so that one whose frame has another axis upwards is upright too; one that is made in the air, as
/// on a table, stands on the floor.
[[nodiscard]] Result<OpenedModels> openModels(Application& application, const std::string& file, OpenOptions options);
/// Whether it is what openModels() has put together.
[[nodiscard]] bool isOfModels(const LoadedProject& loaded);
/// What is found in the text that openModels() writes has its place at the model.
[[nodiscard]] Diagnostics atTheirModels(const LoadedProject& loaded, const Diagnostics& diagnostics);
[[nodiscard]] SourceTable withoutModels(const SourceTable& sources);

} // namespace trundle
