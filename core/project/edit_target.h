#pragma once
// Where an edit goes: one rule for every gesture, command and panel.
//
// A value that is changed on an instance becomes an override of that instance, unless its config is located in the same file and this
// is its only instance: then it goes into the config. A value that an instance overrides already is changed where it is written.
// A change of structure (insert, remove, move, rename) goes into the config itself. Where others use that config too, the user decides
// between all of them and a copy. A config that came with the program is read-only: it is always copied.

#include <set>
#include <string>
#include <vector>

#include "project/config_users.h"
#include "project/plans.h"

namespace trundle {

struct EditTarget {
    std::string path;             ///< of what is changed: "RobotConfig.Rover.chassis.hull.Mass", or the path that was asked about
    FileId file = 0;              ///< whose text is changed
    const Part* config = nullptr; ///< the config that the object is part of; nullptr: it is part of none
    const Part* instance = nullptr; ///< through which the path leads; nullptr: through none
    bool isOverride = false;        ///< the instance sets the value in place of its config's
    bool isShipped = false;         ///< the change would go into a text that came with the program, other than the opened file
    std::size_t instances = 0;      ///< of the config in this load
    std::vector<std::string> users; ///< texts of the project that place the config; only where a config would be changed

    /// Whether others get the change as well: another instance, another file, or whoever imports the config's file later.
    [[nodiscard]] bool isShared(const Loaded& loaded) const;
};

/// Whether a file came with the program. The opened file is the user's to edit: Save As keeps it elsewhere.
[[nodiscard]] bool isShippedFile(const Loaded& loaded, FileId file);
/// The Robots, Statics, Grids and Scatters of a load that are made from a config, in the order of the text.
[[nodiscard]] std::vector<const Part*> instancesOf(const Loaded& loaded, const Part& config);

/// Where a value goes that is set under this path ("robot0.leftMotor.Resistance"). A path that leads nowhere comes back unchanged.
[[nodiscard]] EditTarget targetOfValue(const Loaded& loaded, const std::string& propertyPath, ConfigUsers& users);
/// Where a change of a config's structure goes that was made through `instance`, or, where that is null, in the config itself.
[[nodiscard]] EditTarget targetOfStructure(const Loaded& loaded, const Part& config, const Part* instance, ConfigUsers& users);

/// The configs inside of which a plan changes something, each once.
[[nodiscard]] std::vector<const Part*> configsChangedBy(const Loaded& loaded, const EditPlan& plan);

/// Writes a copy of a config under a free name before the first of `instances`, which use it from then on; they are all of one file.
/// Without instances the copy goes to the end of the opened file. Comments and the author's layout stay; what the config imports or
/// names by a relative path is found from the new place as well. What its block imports from one of the files `inlined` (absolute)
/// is written out in the copy, so that it can be changed there alone. `selects` is the path of the copy.
[[nodiscard]] Result<EditPlan> planCopyConfig(const Loaded& loaded, const Part& config, const std::vector<const Part*>& instances,
                                              const std::set<std::string>& inlined = {});

} // namespace trundle
