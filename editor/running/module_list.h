#pragma once
// The modules of an experiment, listed without running their code.

#include <string>
#include <vector>

#include <QString>

#include "app/locations.h"
#include "app/open_options.h"
#include "project/loading/loaded_project.h"

namespace trundle {

/// One #loadModule of the project.
struct ModuleInfo {
    std::string written; ///< as in the text: "controllers/linear_motion"
    std::string library; ///< absolute path; empty if not found
    std::vector<std::string> kinds;
    QString version;     ///< version of the SDK that it was built with
    QString trouble;     ///< why it cannot be used; empty if it can
    bool trusted = true; ///< false: found, but in a folder that is not trusted
    SourceRange range;   ///< of the path in the text
    std::string usedBy;  ///< a robot that uses one of its kinds; empty: none
};
[[nodiscard]] std::vector<ModuleInfo> modulesOf(const LoadedProject& loaded, const OpenOptions& options, const Locations& places);

} // namespace trundle
