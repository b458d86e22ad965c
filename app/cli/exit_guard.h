#pragma once

namespace trundle {

/// While it lives, an exit() of the whole process is a controller's doing: the program then says so and ends with kExitController
/// instead of passing for a run that went well. A crash is said too before it takes its course. One at a time.
class ExitGuard {
public:
    ExitGuard();
    ~ExitGuard();
    ExitGuard(const ExitGuard&) = delete;
    ExitGuard& operator=(const ExitGuard&) = delete;
};

} // namespace trundle
