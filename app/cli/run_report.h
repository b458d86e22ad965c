#pragma once
// The results of a run, independent of the output format.

#include <cstdint>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "cli/drive_statistics.h"
#include "lang/source_text.h"
#include "run/runner.h"

namespace trundle {

struct RunReport {
    std::string name;       ///< of the experiment: its file name without folder and extension
    std::string unreadable; ///< the file as given by the user, if it cannot be read
    double wallS = 0;
    bool interrupted = false;
    std::vector<DriveTotals> drives;
    std::vector<Diagnostic> diagnostics; ///< of the text and the run
    SourceTable sources;
    Runner* runner = nullptr; ///< nullptr if the run did not start
};

/// The final summary as text.
[[nodiscard]] std::string runSummary(const RunReport& report);
/// The object printed by --json.
[[nodiscard]] std::string runJson(const RunReport& report);
/// The members of its "robots", without braces: current poses, no signals.
[[nodiscard]] std::string posesJsonMembers(const World& world);
/// 16 hex digits.
[[nodiscard]] std::string hashText(std::uint64_t hash);

} // namespace trundle
