#pragma once
#include <cstdint>
#include <optional>

#include <CLI/App.hpp>

#include "parts/open_options.h"
#include "render/render_entry.h"

namespace trundle {

/// Adds -I, --modules and --trust.
void addOpenOptions(CLI::App& command, OpenOptions& options);
/// Adds --set.
CLI::Option* addSetOption(CLI::App& command, OpenOptions& options);
/// Adds --look.
void addLookOption(CLI::App& command, LookChoice& look);

struct PictureSize {
    std::uint32_t width = 0, height = 0;
};
/// "1280x720", from 1x1 to 4096x4096.
[[nodiscard]] std::optional<PictureSize> pictureSize(const std::string& text);

// Checks of what is given for an option; empty where all is well.
[[nodiscard]] std::string sizeProblem(const std::string& text);
[[nodiscard]] std::string finiteProblem(const std::string& text); ///< a range alone lets "nan" through
[[nodiscard]] std::string emptyProblem(const std::string& text);

/// Where both are given, which says nothing: CLI::ValidationError.
void refuseSizeOfCamera(const CLI::Option& camera, const CLI::Option& size);

} // namespace trundle
