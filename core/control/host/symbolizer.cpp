#include "control/host/symbolizer.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <sstream>

#include "base/clean_text.h"
#include "base/platform/process.h"

namespace trundle {
namespace {

constexpr std::size_t kMostFrames = 40;
constexpr double kTimeoutS = 10;

std::string hex(std::uint64_t number) {
    char text[24];
    std::snprintf(text, sizeof text, "0x%llx", static_cast<unsigned long long>(number));
    return text;
}

void setPlace(SourceFrame& frame, std::string place) {
    if (const std::size_t note = place.find(" (discriminator"); note != std::string::npos) place.erase(note);
    const std::size_t colon = place.rfind(':');
    if (colon == std::string::npos || place.starts_with("??")) return;
    std::from_chars(place.data() + colon + 1, place.data() + place.size(), frame.line);
    frame.file = std::filesystem::path(place.substr(0, colon)).lexically_normal().string();
}

/// Blocks of an address line and pairs of a function line and a "file:line" line.
std::vector<SourceFrame> parse(const std::string& text, const std::vector<std::string>& addresses) {
    std::vector<SourceFrame> frames;
    std::istringstream lines(text);
    std::string function, place;
    std::size_t block = 0;
    while (std::getline(lines, function)) {
        if (function.starts_with("0x")) {
            ++block;
            continue;
        }
        if (block == 0 || block > addresses.size() || !std::getline(lines, place)) break;
        SourceFrame frame;
        frame.address = addresses[block - 1];
        if (!function.starts_with("??")) frame.function = cleanText(function);
        setPlace(frame, cleanText(place));
        frames.push_back(std::move(frame));
    }
    return frames;
}

bool isOfSdk(const SourceFrame& frame) { return frame.file.find("/include/trundle/") != std::string::npos; }

} // namespace

std::vector<SourceFrame> symbolize(const std::string& library,
                                   const std::vector<std::pair<std::uint32_t, std::uint64_t>>& frames) {
    ProcessRequest request;
    request.program = "/usr/bin/env";
    request.arguments = {"addr2line", "-a", "-f", "-C", "-i", "-e", library};
    request.seconds = kTimeoutS;
    std::vector<std::string> addresses;
    std::vector<SourceFrame> plain;
    const std::string name = std::filesystem::path(library).filename().string();
    for (const auto& [index, offset] : frames) {
        if (index != 0 || plain.size() >= kMostFrames) continue;
        addresses.push_back(name + "+" + hex(offset));
        // A return address is behind the call; the innermost frame of a signal is not, but the byte before it has the same line.
        request.arguments.push_back(hex(offset > 0 ? offset - 1 : 0));
        plain.push_back({{}, {}, 0, addresses.back()});
    }
    if (plain.empty()) return plain;
    const auto run = runProcess(request);
    if (!run || !run.value().succeeded()) return plain;
    std::vector<SourceFrame> found = parse(run.value().output, addresses);
    return found.empty() ? plain : found;
}

const SourceFrame* ownFrame(const std::vector<SourceFrame>& frames) {
    const auto isOwn = [](const SourceFrame& frame) {
        return frame.line > 0 && !frame.file.starts_with("/usr/") && !isOfSdk(frame) &&
               frame.file.find("/include/c++/") == std::string::npos && frame.file.find("/lib/python3") == std::string::npos;
    };
    const auto found = std::ranges::find_if(frames, isOwn);
    return found == frames.end() ? nullptr : &*found;
}

std::vector<std::string> backtraceOf(const std::vector<SourceFrame>& frames) {
    std::vector<std::string> lines;
    std::size_t same = 0;
    const auto fold = [&] {
        if (same > 0) lines.push_back("\u2026 " + std::to_string(same) + " more of the same");
        same = 0;
    };
    std::string last;
    for (const SourceFrame& frame : frames) {
        if (isOfSdk(frame)) continue;
        std::string text = frameText(frame);
        if (text == last) {
            ++same;
            continue;
        }
        fold();
        lines.push_back(last = std::move(text));
    }
    fold();
    return lines;
}

std::string frameText(const SourceFrame& frame) {
    const std::string function = frame.function.empty() ? frame.address : frame.function;
    return frame.line > 0 ? function + " at " + frame.file + ":" + std::to_string(frame.line) : function;
}

} // namespace trundle
