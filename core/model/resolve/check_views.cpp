// Checks views, lights and image logs before a run.
#include <algorithm>
#include <set>

#include "model/kinds/world_fields.h"
#include "model/resolve/resolve_steps.h"

namespace trundle {

namespace {

std::vector<std::string> cameraPaths(const ExperimentSpec& experiment) {
    std::vector<std::string> paths;
    for (const RobotSpec& robot : experiment.robots) {
        if (!robot.config) continue;
        for (const ComponentSpec& device : robot.config->devices)
            if (device.kind == "Camera") paths.push_back(robot.name + "/" + device.name);
    }
    return paths;
}

std::vector<std::string> viewNames(const ExperimentSpec& experiment) {
    std::vector<std::string> names;
    for (const ComponentSpec& look : experiment.looks)
        if (look.kind == "View") names.push_back(look.name);
    return names;
}

void checkIsThere(ResolveContext& context, const ComponentSpec& log, const char* key, const char* what,
                  const std::vector<std::string>& names) {
    const ResolvedValue* value = log.find(key);
    const std::string written = log.text(key);
    if (!value || written.empty() || std::find(names.begin(), names.end(), written) != names.end()) return;
    const bool known = value->range.known();
    context.unknownReference(key, what, written, known ? value->range : log.nameRange, known && value->origin != Origin::Param,
                             names);
}

} // namespace

void checkFrameLogs(ResolveContext& context) {
    if (context.diagnostics.errorCount() > 0) return; // their targets may exist but be invalid
    std::set<SourceRange> reported;                   // the members of a Repeat have one block
    for (const ComponentSpec& log : context.out.logs) {
        if (log.kind != "FrameLog" || reported.contains(log.nameRange)) continue;
        const std::size_t before = context.diagnostics.all().size();
        checkIsThere(context, log, "Camera", "camera", cameraPaths(context.out));
        checkIsThere(context, log, "View", "view", viewNames(context.out));
        const ResolvedValue* view = log.find("View");
        if (view && !log.text("View").empty() && !log.text("Camera").empty())
            context.diagnostics.warning(Code::Conflict, view->range.known() ? view->range : log.nameRange,
                                        "FrameLog " + log.name + " has a Camera, so its View takes no pictures");
        if (context.diagnostics.all().size() > before) reported.insert(log.nameRange);
    }
}

void AppearanceChecker::check(const Record& record, const Part& part) {
    if (record.kind->name == "View") checkView(record, part);
    if (record.kind->name == "Light") checkLight(record, part);
}

void AppearanceChecker::checkView(const Record& record, const Part& part) {
    const ViewFields view = fieldsFrom<ViewFields>(record);
    if (view.eye == view.target)
        m_context.diagnostics.warning(Code::Conflict, record.rangeOf("Eye", part.nameRange()),
                                      "Eye and Target of " + part.title() +
                                          " are one place: it looks nowhere, and no picture can be taken from it");
    if (view.mode == "fixed" || !view.robot.value_or("").empty()) return;
    Diagnostic& d =
        m_context.diagnostics.warning(Code::MissingRequired, record.rangeOf("Mode", part.nameRange()),
                                      part.title() + " says Mode = " + view.mode + " but names no Robot: it stays where it is");
    if (!m_context.out.robots.empty()) m_context.fixAdd(d, part, "Robot", m_context.out.robots.front().name);
}

void AppearanceChecker::checkLight(const Record& record, const Part& part) {
    const LightFields light = fieldsFrom<LightFields>(record);
    if (light.mode == "lamp") {
        if (++m_lamps == kMaxLamps + 1)
            m_context.diagnostics.warning(Code::TooManyObjects, part.nameRange(),
                                          "only " + std::to_string(kMaxLamps) + " lamps can shine: " + part.title() +
                                              " and those after it do not");
        return;
    }
    if (++m_suns == 2)
        m_context.diagnostics.warning(Code::Conflict, part.nameRange(),
                                      "there is one sun, the first one: " + part.title() +
                                          " does not shine; a light of its own place has Mode = lamp");
    if (light.direction == Triple{})
        m_context.diagnostics.warning(Code::OutOfRange, record.rangeOf("Direction", part.nameRange()),
                                      "Direction of " + part.title() +
                                          " has no length: the sun shines from where it does without one");
}

} // namespace trundle
