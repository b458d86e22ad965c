#pragma once
#include <cstdint>
#include <optional>

#include <CLI/App.hpp>

#include "app/open_options.h"
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

// Validators of option arguments: return an error message, or an empty text if valid.
[[nodiscard]] std::string sizeProblem(const std::string& text);
[[nodiscard]] std::string finiteProblem(const std::string& text); ///< needed because CLI::Range accepts "nan"
[[nodiscard]] std::string emptyProblem(const std::string& text);

/// Throws CLI::ValidationError if both are given, since a camera has its own size.
void refuseSizeOfCamera(const CLI::Option& camera, const CLI::Option& size);

} // namespace trundle
