#pragma once
#include <memory>
#include <string>
#include <vector>

#include "project/text_overlay.h"

namespace trundle {

struct Loaded;

/// What every command that loads an experiment takes.
struct OpenOptions {
    std::vector<std::string> includes; ///< further folders to look for imported files in
    std::vector<std::string> modules;  ///< folders whose modules are trusted, beside the program's own
    std::vector<std::string> sets;     ///< "robot0.leftMotor.Resistance=3"
    bool trust = false;                ///< also the modules that lie beside the experiment's files

    // What an editor adds; see ProjectOptions.
    TextOverlay texts;
    std::shared_ptr<const Loaded> previous;
    bool shownFromProject = false;
    /// Takes only meshes and height maps that were read before, so that the load waits for no helper process. Of another it says
    /// that it is being read, and Loaded::pending is set.
    bool meshesLater = false;
};

} // namespace trundle
