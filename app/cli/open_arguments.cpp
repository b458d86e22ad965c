#include "cli/open_arguments.h"

#include <charconv>
#include <cmath>
#include <cstdlib>

#include <CLI/Error.hpp>

namespace trundle {
namespace {

constexpr std::uint32_t kMaxSide = 4096;

/// The error message for a --set argument; empty if it is valid.
std::string setProblem(const std::string& text) {
    const std::size_t equals = text.find('=');
    return equals != std::string::npos && equals > 0 ? std::string() : "give PATH=VALUE, as in robot0.leftMotor.Resistance=3";
}

} // namespace

void addOpenOptions(CLI::App& command, OpenOptions& options) {
    command.add_option("-I", options.includes, "Also look for imported files in DIR (may be repeated)")
        ->type_name("DIR")
        ->check(CLI::ExistingDirectory)
        ->allow_extra_args(false);
    command.add_option("--modules", options.modules, "Also look for modules in DIR, and trust those there (may be repeated)")
        ->type_name("DIR")
        ->check(CLI::ExistingDirectory)
        ->allow_extra_args(false);
    command.add_flag("--trust", options.trust, "Trust the modules that lie beside the experiment's files");
}

CLI::Option* addSetOption(CLI::App& command, OpenOptions& options) {
    return command.add_option("--set", options.sets, "Set one value: robot0.leftMotor.Resistance=3 (may be repeated)")
        ->type_name("PATH=VALUE")
        ->check(&setProblem)
        ->allow_extra_args(false);
}

void addLookOption(CLI::App& command, LookChoice& look) {
    command
        .add_option_function<std::string>(
            "--look",
            [&look](const std::string& name) {
                look = name == "rich" ? LookChoice::Rich : name == "fast" ? LookChoice::Fast : LookChoice::Automatic;
            },
            "How pictures look: fast, rich (shadows on things too, dark corners, smooth edges) or automatic, which is rich on a "
            "graphics card. What a robot's camera sees is automatic, whatever is said here")
        ->type_name("LOOK")
        ->check(CLI::IsMember({"automatic", "fast", "rich"}).description(""));
}

std::optional<PictureSize> pictureSize(const std::string& text) {
    PictureSize size;
    const char* const end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.width);
    if (width.ec != std::errc() || width.ptr == end || *width.ptr != 'x') return std::nullopt;
    const auto height = std::from_chars(width.ptr + 1, end, size.height);
    if (height.ec != std::errc() || height.ptr != end) return std::nullopt;
    const auto fits = [](std::uint32_t side) { return side >= 1 && side <= kMaxSide; };
    return fits(size.width) && fits(size.height) ? std::optional(size) : std::nullopt;
}

std::string sizeProblem(const std::string& text) {
    return pictureSize(text) ? std::string() : "a size is written like 1280x720, from 1x1 to 4096x4096, not " + text;
}

std::string finiteProblem(const std::string& text) {
    return std::isfinite(std::strtod(text.c_str(), nullptr)) ? std::string() : "give a number, not " + text;
}

std::string emptyProblem(const std::string& text) {
    if (text.empty()) return "a name is missing";
    return text.starts_with("--")
               ? "a name is missing before " + text + " (write ./" + text + " for a file or folder of that name)"
               : std::string();
}

void refuseSizeOfCamera(const CLI::Option& camera, const CLI::Option& size) {
    if (!camera.empty() && !size.empty())
        throw CLI::ValidationError("--size", "a camera has a Resolution of its own; leave --size out");
}

} // namespace trundle
