#include "project/edits/controllers.h"

#include <algorithm>
#include <set>

#include "model/robot_path.h"
#include "project/edits/module_lines.h"
#include "schema/value_words.h"

namespace trundle {
namespace {

const Part* instanceAt(const LoadedProject& loaded, std::string_view path) {
    const Part* part = loaded.outline->world.find(std::string(path));
    if (!part) part = layoutOfMember(*loaded.outline, path);
    if (!part || !(part->is(Role::Instance) || part->is(Role::Layout))) return nullptr;
    const auto isMoving = [&](const RobotSpec& robot) { return robot.scenery && robot.range == part->range; };
    const Part* config = part->is(Role::Layout) ? configOf(loaded, *part) : nullptr;
    const bool isScenery = part->kind->name == "Static" || (config && config->kind->name == "StaticConfig");
    return !isScenery || std::ranges::any_of(loaded.experiment->robots, isMoving) ? part : nullptr;
}

/// The instance that a path is of or in, and its path in the text: "swarm" of "swarm_3", "row.cart" of "row_3.cart.chassis".
std::pair<const Part*, std::string> instanceIn(const LoadedProject& loaded, std::string_view path) {
    const std::string_view start = shortestStart(path, [&](std::string_view name) { return instanceAt(loaded, name) != nullptr; });
    const Part* part = start.empty() ? nullptr : instanceAt(loaded, start);
    std::string name = part ? part->name : std::string();
    if (firstWord(start) != start)
        eachInWorld(*loaded.outline, [&](const Part& each, const std::string& at) {
            if (&each == part) name = at;
        });
    return {part, std::move(name)};
}

/// Whether every valid value of the old property is valid for the new one and means the same.
bool carriesOver(const Property* from, const Property* to) {
    if (!from || !to || from->type != to->type || from->unit != to->unit || from->choices != to->choices) return false;
    const bool low = to->minimum < from->minimum || (to->minimum == from->minimum && (from->minExclusive || !to->minExclusive));
    const bool high = to->maximum > from->maximum || (to->maximum == from->maximum && (from->maxExclusive || !to->maxExclusive));
    return low && high && to->minCount <= from->minCount && to->maxCount >= from->maxCount;
}

/// "Wander brain { Speed=0.4 }" from "RandomDrive brain { Speed=0.4 Period=1 }".
std::string replacement(const LoadedProject& loaded, const Part& robot, const Part& old, const Kind& kind) {
    std::string text = templateOf(loaded, kind, robot.name);
    const std::size_t open = text.find('{'), close = text.rfind('}');
    if (open == std::string::npos || close == std::string::npos) return text;
    std::string inside;
    const std::string required = text.substr(open + 1, close - open - 1);
    for (const SourceAssignment& a : old.assignments.all()) {
        const bool kept = a.path.size() == 1 && old.kind && carriesOver(old.kind->find(a.key), kind.find(a.key));
        const bool given = required.find(a.key + "=") != std::string::npos || required.find(a.key + " =") != std::string::npos;
        if (kept && !given) inside += " " + a.key + "=" + std::string(loaded.outline->texts().slice(a.valueRange()));
    }
    std::string needed = required;
    while (!needed.empty() && (needed.back() == ' ' || needed.back() == '\n')) needed.pop_back();
    const std::string all = needed + inside;
    return kind.name + " " + (old.block->name ? old.name : "brain") + (all.empty() ? " {}" : " {" + all + " }");
}

/// "robot0" and its first controller, or "robot0.brain".
const Part* controllerAt(const Part& robot, std::string_view target) {
    const std::vector<const Part*> all = controllersOf(robot);
    const auto named = std::ranges::find(all, lastWord(target), &Part::name);
    return named != all.end() ? *named : all.empty() ? nullptr : all.front();
}

void join(EditPlan& plan, EditPlan more) {
    for (auto& [file, edits] : more.edits) {
        auto& list = plan.edits[file];
        for (TextEdit& edit : edits) {
            const bool known = std::ranges::any_of(list, [&](const TextEdit& e) {
                return e.range == edit.range && e.text == edit.text && e.range.range.size() > 0;
            });
            if (!known) list.push_back(std::move(edit));
        }
    }
    for (std::string& path : more.selects) plan.selects.push_back(std::move(path));
}

} // namespace

bool ControlledRobot::isAmong(const std::vector<std::string>& targets) const {
    return std::ranges::any_of(targets, [this](const std::string& each) { return each == path || each == target(); });
}

std::vector<ControlledRobot> controlledRobots(const LoadedProject& loaded) {
    std::vector<ControlledRobot> robots;
    eachInWorld(*loaded.outline, [&](const Part& found, const std::string& path) {
        const Part* part = instanceAt(loaded, path);
        if (part != &found) return;
        const std::vector<const Part*> controllers = controllersOf(*part);
        ControlledRobot robot{path, {}, {}, 1, controllers.size()};
        if (part->is(Role::Layout) || path != part->name)
            robot.members = static_cast<std::size_t>(std::ranges::count_if(
                loaded.experiment->robots, [&](const RobotSpec& r) { return r.range == part->range && r.name != path; }));
        if (controllers.empty()) robots.push_back(robot);
        for (const Part* controller : controllers) {
            robot.kind = controller->kind->name;
            robot.controller = controller->name;
            robots.push_back(robot);
        }
    });
    return robots;
}

std::vector<std::string> robotsAmong(const LoadedProject& loaded, const std::vector<std::string>& paths) {
    std::vector<std::string> robots;
    for (const std::string& path : paths) {
        const auto [part, name] = instanceIn(loaded, path);
        if (!part) continue;
        const std::vector<const Part*> controllers = controllersOf(*part);
        const auto chosen = std::ranges::find(controllers, lastWord(path), &Part::name);
        std::string robot = controllers.size() > 1 && chosen != controllers.end() ? name + "." + (*chosen)->name : name;
        if (std::ranges::find(robots, robot) == robots.end()) robots.push_back(std::move(robot));
    }
    return robots;
}

std::vector<ControllerChoice> controllerChoices(const LoadedProject& loaded, const std::vector<Kind>& moduleKinds,
                                                const std::string& shippedModules) {
    std::vector<ControllerChoice> choices;
    std::set<std::string> known;
    for (const Kind* kind : loaded.registry->all())
        if (kind->role == Role::Controller && known.insert(kind->name).second) choices.push_back({*kind, {}});
    for (const Kind& kind : moduleKinds)
        if (kind.role == Role::Controller && known.insert(kind.name).second)
            choices.push_back({kind, writtenFor(kind.module, loaded, shippedModules)});
    std::ranges::stable_sort(choices, {}, [](const ControllerChoice& c) { return std::pair(!c.module.empty(), c.kind.name); });
    return choices;
}

Result<EditPlan> planAssign(const LoadedProject& loaded, const std::vector<std::string>& robots, const Kind& controller) {
    if (robots.empty()) return Error{Code::UnknownReference, "no robot is selected"};
    EditPlan plan;
    for (const std::string& name : robots) {
        const auto [robot, path] = instanceIn(loaded, name);
        if (!robot) return Error{Code::UnknownReference, name + " is no robot"};
        if (const Part* old = controllerAt(*robot, name)) {
            if (old->kind->name == controller.name) continue;
            plan.edits[old->file].push_back({old->range, replacement(loaded, *robot, *old, controller)});
            plan.selects.push_back(path + "." + (old->block->name ? old->name : "brain"));
            continue;
        }
        std::string text = templateOf(loaded, controller, robot->name);
        const std::size_t open = text.find('{');
        if (open != std::string::npos) text = controller.name + " brain " + text.substr(open);
        Result<EditPlan> one = planInsert(loaded, path, text);
        if (!one) return one.error();
        join(plan, std::move(one).value());
    }
    if (plan.edits.empty())
        return Error{Code::DuplicateName,
                     robots.size() == 1 ? robots[0] + " has this controller already" : "they have this controller already"};
    return plan;
}

Result<EditPlan> planUnassign(const LoadedProject& loaded, const std::vector<std::string>& robots) {
    std::vector<std::string> paths;
    for (const std::string& name : robots)
        if (const auto [robot, path] = instanceIn(loaded, name); robot)
            if (const Part* controller = controllerAt(*robot, name)) paths.push_back(path + "." + controller->name);
    if (paths.empty())
        return Error{Code::UnknownReference, robots.empty() ? "no robot is selected" : "there is no controller to remove"};
    Result<EditPlan> plan = planRemove(loaded, paths);
    if (plan) { // the user may assign another controller next
        plan.value().selects.clear();
        for (const std::string& name : robots) plan.value().selects.push_back(instanceIn(loaded, name).second);
    }
    return plan;
}

} // namespace trundle
