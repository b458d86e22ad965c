#pragma once
#include "base/codes.h"

namespace trundle {

/// The exit codes of the program; the same for every subcommand.
enum ExitCode : int {
    kExitDone = 0,
    kExitText = 1,       ///< errors in the text, or a module that does not load; `check`, `format --check`: findings
    kExitUsage = 2,      ///< wrong command line, or a FILE that cannot be read
    kExitBlewUp = 3,     ///< the simulation became unstable
    kExitController = 4, ///< a controller failed, or module code crashed, ended the program or did not return
    kExitInterrupted = 130,
};

/// The exit code of a run that ended with this diagnostic code.
[[nodiscard]] constexpr ExitCode exitCodeFor(Code code) {
    if (code == Code::BlowUp || code == Code::EngineFault) return kExitBlewUp;
    if (code == Code::ControllerFailed || code == Code::UnknownPort || code == Code::DeviceSetup) return kExitController;
    if (code == Code::NoDuration) return kExitUsage;
    if (code == Code::Interrupted) return kExitInterrupted;
    return kExitText;
}

} // namespace trundle
