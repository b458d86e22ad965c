#pragma once
// What the fuzzers and the replay of their finds do with some bytes. Each aborts where a promise is broken.

#include <cstdint>
#include <memory>
#include <span>

#include "project/project.h"

namespace trundle::fuzz {

/// A text of any bytes: parsed, printed, formatted, edited, resolved, its diagnostics rendered.
void tryText(std::span<const std::uint8_t> bytes);
/// An experiment that the schema allows, steered by the bytes: built and run for 20 ticks under wild commands. It may be refused or
/// end in a fault that is reported; it may not crash, hang or publish what is not a number.
void tryWorld(std::span<const std::uint8_t> bytes);

/// Built-in kinds of model, devices and logs.
[[nodiscard]] std::shared_ptr<const Registry> builtInKinds();
/// Opens a text as if it stood alone in an empty folder, with no modules and no meshes.
[[nodiscard]] std::shared_ptr<const LoadedProject> open(std::span<const std::uint8_t> bytes);

void require(bool holds);

} // namespace trundle::fuzz
