// Format: `  File "/a/b.py", line 12 in update`, one line for each call.
#include "control/host/python_report.h"

#include <charconv>
#include <sstream>

#include "base/clean_text.h"

namespace trundle {

std::vector<SourceFrame> framesOfPython(const std::string& report) {
    constexpr std::string_view kFile = "  File \"", kLine = "\", line ", kIn = " in ";
    std::vector<SourceFrame> frames;
    std::istringstream lines(cleanText(report));
    for (std::string line; std::getline(lines, line);) {
        const std::size_t number = line.rfind(kLine);
        if (!line.starts_with(kFile) || number == std::string::npos) continue;
        SourceFrame frame;
        frame.file = line.substr(kFile.size(), number - kFile.size());
        const char* const end = line.data() + line.size();
        const auto [after, error] = std::from_chars(line.data() + number + kLine.size(), end, frame.line);
        const std::string_view rest(after, static_cast<std::size_t>(end - after));
        if (error != std::errc() || !rest.starts_with(kIn)) continue;
        frame.function = rest.substr(kIn.size());
        if (frame.file.starts_with("<") || frame.file.find("/python/trundle/") != std::string::npos ||
            frame.file.ends_with("/python/run_controllers.py"))
            continue;
        frames.push_back(std::move(frame));
    }
    return frames;
}

} // namespace trundle
