#pragma once
// Turns edits of objects into edits of text. A plan changes nothing itself: it lists which bytes of which file are replaced, in
// that file's own style, so that the edit can be applied and undone in one step.

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "base/text_edit.h"
#include "project/loading/project.h"
#include "project/objects/object_location.h"

namespace trundle {

/// Edits by file, with the FileIds of the load that they were planned for.
using FileEdits = std::map<FileId, std::vector<TextEdit>>;

struct EditPlan {
    FileEdits edits;
    std::vector<std::string> selects; ///< paths of the created, moved or renamed objects, after the edit
    std::string renamedIn = {};       ///< of a rename the path of the config that has the object; others only name it
};

/// Removes the assignment or override of a property, so that the default or the config's value applies again.
[[nodiscard]] Result<EditPlan> planReset(const LoadedProject& loaded, const std::vector<std::string>& propertyPaths);
/// Moves an instance's override into its config.
[[nodiscard]] Result<EditPlan> planPushOverride(const LoadedProject& loaded, const std::string& propertyPath);
/// Writes the config's value as an override into the instance.
[[nodiscard]] Result<EditPlan> planPullOverride(const LoadedProject& loaded, const std::string& propertyPath);
/// Renames an object and updates every reference to it, in all open files. A Param is identified by its block's path and its name
/// ("RobotConfig.Rover.trackWidth"), at the top level by its name alone.
[[nodiscard]] Result<EditPlan> planRename(const LoadedProject& loaded, const std::string& path, const std::string& name);
/// Removes blocks, and their names from lists that have others too. Fails, with the names of the users, if something else still
/// refers to one of them. A definition that came with the program, which is read-only, is removed with its import, if nothing of
/// that file is used.
[[nodiscard]] Result<EditPlan> planRemove(const LoadedProject& loaded, const std::vector<std::string>& paths);
/// Copies objects next to their originals, under free names, shifted by `offset` (m).
[[nodiscard]] Result<EditPlan> planDuplicate(const LoadedProject& loaded, const std::vector<std::string>& paths,
                                             const Vec3& offset);
/// Inserts blocks given as text below `parent` ("" is the top level of the opened file), renamed where a name is taken, and adds
/// the imports that they need; `imports` lists files ("robots/simple_robot.sim") or whole directives ("#loadModule walker").
///
/// For parts of robots, "robot0" as a parent means its config. Params are inserted unless they exist already. Fails if a name is
/// undefined, or if a Param of the same name has another value. Blocks of the top level are inserted into `file`.
[[nodiscard]] Result<EditPlan> planInsert(const LoadedProject& loaded, const std::string& parent, const std::string& text,
                                          const std::vector<std::string>& imports = {}, FileId file = 0);
/// Moves blocks before `before` (an object in `parent`), or to the end of `parent` if `before` is "". A block that keeps its
/// parent stays in its file, near the requested position; only `file` moves top-level blocks to another file. A geom or body that
/// gets another parent keeps its pose in the world: its Pos and HPR are rewritten. Fails if that is not possible for every robot
/// of the config.
[[nodiscard]] Result<EditPlan> planMove(const LoadedProject& loaded, const std::vector<std::string>& paths,
                                        const std::string& parent, const std::string& before, FileId file = kNoFile);
/// Replaces a Grid or Scatter by single robots at the poses of its members.
[[nodiscard]] Result<EditPlan> planReplaceBySingles(const LoadedProject& loaded, const std::string& path);
/// Whether an object is a Grid or Scatter or part of one, and that is in no Repeat.
[[nodiscard]] bool canReplaceBySingles(const LoadedProject& loaded, const std::string& path);

/// The text of blocks for the clipboard, in text order.
[[nodiscard]] std::string textOf(const LoadedProject& loaded, const std::vector<std::string>& paths);
/// A free name derived from `preferred`: "robot0" or, if taken, "robot1" ...
[[nodiscard]] std::string freeName(const LoadedProject& loaded, const std::string& parent, const std::string& preferred);
/// The smallest valid block of a kind, with its required properties ("Sphere sphere { Radius=0.1 }"), preceded by the missing
/// blocks that it needs. Empty for the settings.
[[nodiscard]] std::string templateOf(const LoadedProject& loaded, const Kind& kind, const std::string& parent);
/// A movable object for the top level with one shape of this kind: a RobotConfig and a Robot without joints, devices and
/// controller. "" for a kind that cannot be part of a body.
[[nodiscard]] std::string objectTemplateOf(const LoadedProject& loaded, const Kind& geom);

} // namespace trundle
