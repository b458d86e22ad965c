#pragma once
// Edits of objects as edits of texts. Each plan changes nothing by itself: it says which bytes of which file become what, in
// that file's own style, so that one splice does it and one step of undo takes it back.

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "base/text_edit.h"
#include "project/object_place.h"
#include "project/project.h"

namespace trundle {

/// Edits by the file they change, as numbered in the load they were planned for.
using FileEdits = std::map<FileId, std::vector<TextEdit>>;

struct EditPlan {
    FileEdits edits;
    std::vector<std::string> selects; ///< paths of what is made, moved or renamed, once done
};

/// Removes the assignment or override that gives a property its value, so that the default or the config's value holds again.
[[nodiscard]] Result<EditPlan> planReset(const Loaded& loaded, const std::vector<std::string>& propertyPaths);
/// Moves an instance's override into its config.
[[nodiscard]] Result<EditPlan> planPushOverride(const Loaded& loaded, const std::string& propertyPath);
/// Writes the config's value as an override into the instance.
[[nodiscard]] Result<EditPlan> planPullOverride(const Loaded& loaded, const std::string& propertyPath);
/// Gives an object another name and changes every reference to it, in all open files. A Param is named by its block's path and its
/// name ("RobotConfig.Rover.trackWidth"), one of the top level by its name alone.
[[nodiscard]] Result<EditPlan> planRename(const Loaded& loaded, const std::string& path, const std::string& name);
/// Removes blocks. Fails, naming who, where something else still refers to one of them.
[[nodiscard]] Result<EditPlan> planRemove(const Loaded& loaded, const std::vector<std::string>& paths);
/// Copies beside the originals, with names that are free.
[[nodiscard]] Result<EditPlan> planDuplicate(const Loaded& loaded, const std::vector<std::string>& paths, const Vec3& offset);
/// Adds blocks given as text below `parent` ("" is the top level of the opened file), named anew where a name is taken, and
/// imports what they use where `imports` names the files ("robots/simple_robot.sim") or whole directives ("#loadModule walker").
/// "robot0" as a parent means its config for parts of robots; Params go in where none has the name. Fails where a name is missing,
/// or where a Param of the name says something else. What stands at the top level goes into `file`.
[[nodiscard]] Result<EditPlan> planInsert(const Loaded& loaded, const std::string& parent, const std::string& text,
                                          const std::vector<std::string>& imports = {}, FileId file = 0);
/// Gives each of these Robots, Grids or Scatters the controller that `text` describes, in place of one that it has.
[[nodiscard]] Result<EditPlan> planController(const Loaded& loaded, const std::vector<std::string>& robots,
                                              const std::string& text, const std::vector<std::string>& imports = {});
/// Moves blocks before `before` (an object in `parent`), or to the end of `parent` where `before` is "". What has that parent
/// already stays in its file, next to where it was wanted; only `file` takes blocks of the top level to another. A geom or body
/// that gets another parent keeps its place in the world: its Pos and HPR are written anew. Fails where they cannot be the same
/// for every robot of the config.
[[nodiscard]] Result<EditPlan> planMove(const Loaded& loaded, const std::vector<std::string>& paths, const std::string& parent,
                                        const std::string& before, FileId file = kNoFile);
/// Writes the members of a Grid or Scatter out as single robots.
[[nodiscard]] Result<EditPlan> planReplaceBySingles(const Loaded& loaded, const std::string& path);

/// The text of blocks as it would be pasted, in the order of the text.
[[nodiscard]] std::string textOf(const Loaded& loaded, const std::vector<std::string>& paths);
/// A free name made from `wish`: "robot0" or, where that is taken, "robot1" ...
[[nodiscard]] std::string freeName(const Loaded& loaded, const std::string& parent, const std::string& wish);
/// The smallest block of a kind that loads: required properties filled in with values that hold ("Sphere sphere { Radius=0.1 }").
/// What it needs and is not there comes before it, as blocks of their own. Empty for the settings.
[[nodiscard]] std::string templateOf(const Loaded& loaded, const Kind& kind, const std::string& parent);
/// A movable object for the top level that has one shape of this kind: a Robot without joints, devices and controller, after its config.
/// "" for a kind that cannot be part of a body.
[[nodiscard]] std::string objectTemplateOf(const Loaded& loaded, const Kind& geom);

} // namespace trundle
