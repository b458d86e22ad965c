#pragma once
#include <memory>
#include <string>
#include <vector>

#include "project/loading/text_overlay.h"

namespace trundle {

struct LoadedProject;

/// Options of every command that loads an experiment.
struct OpenOptions {
    std::vector<std::string> includes; ///< additional search folders for imported files
    std::vector<std::string> modules;  ///< folders that are searched for modules and trusted, besides the program's own
    std::vector<std::string> trusted;  ///< folders whose modules are trusted, but that are not searched
    std::vector<std::string> sets;     ///< overrides, such as "robot0.leftMotor.Resistance=3"
    bool trust = false;                ///< also trust modules in the folders of the experiment's files

    // Set by the editor only; see ProjectOptions.
    TextOverlay texts;
    std::shared_ptr<const LoadedProject> previous;
    bool shownFromProject = false;
    /// Uses only meshes and height maps that are already cached, so that loading never waits for the reader process. The others
    /// get a diagnostic that they are being read, and LoadedProject::pending is set.
    bool meshesLater = false;
};

} // namespace trundle
