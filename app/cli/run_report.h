#pragma once
// What a run has to tell, whatever form it is told in.

#include <cstdint>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "cli/drive_meter.h"
#include "lang/source_text.h"
#include "run/runner.h"

namespace trundle {

struct RunReport {
    std::string name;       ///< of the experiment: its file without folder and ending
    std::string unreadable; ///< the file as it was named, where it cannot be read
    double wallS = 0;
    bool interrupted = false;
    std::vector<DriveTotals> drives;
    std::vector<Diagnostic> diagnostics; ///< of the text and of the run
    SourceTable sources;
    Runner* runner = nullptr; ///< nullptr where the run did not start
};

/// The closing summary for people.
[[nodiscard]] std::string runSummary(const RunReport& report);
/// The one object of --json.
[[nodiscard]] std::string runJson(const RunReport& report);
/// The members of its "robots", without braces: poses as they are now, no signals.
[[nodiscard]] std::string posesJsonMembers(const World& world);
/// 16 hex digits.
[[nodiscard]] std::string hashText(std::uint64_t hash);

} // namespace trundle
