#pragma once
// Decides which file and block an edit changes: one rule for all commands and panels.
//
// A value changed on an instance becomes an override of that instance, unless its config is defined in the same file and this is
// its only instance: then the config is changed. A value that the instance already overrides is changed in the override. A change
// of structure (insert, remove, move, rename) is made in the config itself. If the config has other users, the user of the editor
// chooses between changing all of them and making a copy. A config shipped with the program is read-only: it is always copied, and
// so are materials, surfaces, antenna patterns and Params. A Part is an instance too, of its PartConfig: the outermost instance of a path
// gets the override. If that is a Part of a shipped config, the config that has the Part is copied.

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "project/edits/plans.h"
#include "project/objects/config_users.h"

namespace trundle {

struct EditTarget {
    std::string path;               ///< of the changed object: "RobotConfig.Rover.chassis.hull.Mass", or the requested path
    FileId file = 0;                ///< the file to be changed
    const Part* config = nullptr;   ///< the config that contains the object; nullptr: none
    const Part* instance = nullptr; ///< the instance that the path leads through; nullptr: none
    bool isOverride = false;        ///< the instance sets the value instead of its config
    bool isShipped = false;         ///< the change would be made in a shipped file other than the opened file
    std::string definition;         ///< shipped, contains the value, and is no config: see shippedDefinitionAt(); empty: none
    std::size_t instances = 0;      ///< number of instances of the config in this load
    std::vector<std::string> users; ///< files of the project that place the config; set only if a config would be changed
};

/// Whether a file was shipped with the program. The opened file never counts: it can be edited, and Save As stores it elsewhere.
[[nodiscard]] bool isShippedFile(const LoadedProject& loaded, FileId file);
/// The Robots, Statics, Grids and Scatters of a load that use a config, or the Parts, in text order.
[[nodiscard]] std::vector<const Part*> instancesOf(const LoadedProject& loaded, const Part& config);

/// The config that has a Part, or that is a variant, so that it changes with the Config of that; nullptr for what is at the top level.
[[nodiscard]] const Part* holderOf(const LoadedProject& loaded, const Part& user);
/// Whether something in the user's own texts uses a config, also through shipped configs.
[[nodiscard]] bool isUsedByOwnTexts(const LoadedProject& loaded, const Part& config);

/// The path of the material, surface, antenna pattern or top-level Param of a shipped file that a path leads to: "Material.red",
/// "side". Empty for everything else.
[[nodiscard]] std::string shippedDefinitionAt(const LoadedProject& loaded, const std::string& path);

/// The target of a value edit under this path ("robot0.leftMotor.Resistance"). A path that leads nowhere is returned unchanged.
[[nodiscard]] EditTarget targetOfValue(const LoadedProject& loaded, const std::string& propertyPath, ConfigUsers& users);
/// The target of a change to a config's structure, made through `instance` or, if that is null, in the config itself.
[[nodiscard]] EditTarget targetOfStructure(const LoadedProject& loaded, const Part& config, const Part* instance,
                                           ConfigUsers& users);

/// The edits of a fix, by file.
[[nodiscard]] FileEdits editsOf(const Fix& fix);
/// The fixes of a diagnostic that can be applied: in shipped files those that change configs only, which are copied. Pointers into
/// the diagnostic.
[[nodiscard]] std::vector<const Fix*> applicableFixes(const LoadedProject& loaded, const Diagnostic& diagnostic);

/// The edits of a fix that was made for the texts `found`, in the texts `loaded`, in which some configs have copies: `renamed` maps
/// the path of a config to that of its copy, or to itself.
[[nodiscard]] Result<EditPlan> planFix(const LoadedProject& found, const Fix& fix, const LoadedProject& loaded,
                                       const std::function<std::string(const std::string&)>& renamed);

/// The configs whose contents a plan changes, each once. Of a rename the one that has the object, without the user's own ones that only
/// name it: these change with it, whatever is decided.
[[nodiscard]] std::vector<const Part*> configsChangedBy(const LoadedProject& loaded, const EditPlan& plan);

/// The shipped definitions whose contents a plan changes, see shippedDefinitionAt().
[[nodiscard]] std::vector<std::string> definitionsChangedBy(const LoadedProject& loaded, const EditPlan& plan);

/// Writes a copy of a config under a free name before the first of `instances`, or before the block of the top level that it is
/// in; they use the copy from then on and must be in one file. Without instances the copy is added at the end of the opened
/// file. Comments and layout are kept; files that the config imports or names by a relative path are also found from the new
/// location. Imports in its block from one of the files `inlined` (absolute) are expanded in the copy, so that they can be
/// edited there alone. Of a shipped config with errors the import is replaced by imports of what is still used, unless the
/// project uses more of its file. `selects` is the path of the copy.
[[nodiscard]] Result<EditPlan> planCopyConfig(const LoadedProject& loaded, const Part& config,
                                              const std::vector<const Part*>& instances,
                                              const std::set<std::string>& inlined = {});

/// Writes a copy of a shipped definition (a path from shippedDefinitionAt()) under a free name before the first block of the opened
/// file, whose references then lead to the copy. So do those in shipped configs with instances in the opened file: the plan changes
/// such configs, which must be copied first. `selects` is the path of the copy.
[[nodiscard]] Result<EditPlan> planCopyDefinition(const LoadedProject& loaded, const std::string& definition);
/// The user's own files, other than the opened one, that refer to a definition: planCopyDefinition() leaves them unchanged.
[[nodiscard]] std::vector<FileId> otherFilesUsing(const LoadedProject& loaded, const std::string& definition);

/// Replaces the imports in the block of a config by their text where they lead to one of the files `inlined` (absolute), directly or
/// through other such files, so that the text can be edited in the config's own file. Empty if none
/// does.
[[nodiscard]] Result<EditPlan> planExpandImports(const LoadedProject& loaded, const Part& config,
                                                 const std::set<std::string>& inlined);

} // namespace trundle
