#pragma once
// Entry points shared by the fuzzers and the replay test. Each aborts when an invariant is violated.

#include <cstdint>
#include <memory>
#include <span>

#include "project/loading/project.h"

namespace trundle::fuzz {

/// Parses, prints, formats, edits and resolves arbitrary bytes as a text, and renders its diagnostics.
void tryText(std::span<const std::uint8_t> bytes);
/// Builds an experiment that the schema allows from the bytes and runs it for 20 ticks with arbitrary commands. It may be refused or
/// end in a reported fault; it must not crash, hang or publish a value that is not finite.
void tryWorld(std::span<const std::uint8_t> bytes);

/// Sends the requests that are decoded from the bytes, most of them valid, to a server that another client uses too. Each is answered
/// or its client closed; the other client is always served. Returns the number of requests.
std::size_t tryRemote(std::span<const std::uint8_t> bytes);

/// Built-in kinds of model, devices and logs.
[[nodiscard]] std::shared_ptr<const Registry> builtInKinds();
/// Opens a text as the only file of a folder, without modules and meshes.
[[nodiscard]] std::shared_ptr<const LoadedProject> open(std::span<const std::uint8_t> bytes);

void require(bool holds);

} // namespace trundle::fuzz
