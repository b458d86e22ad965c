// Checks what controllers say that they need: text fields of a controller's kind that name devices of its robot.

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "check/checks.h"
#include "check/extent.h"
#include "model/port_kinds.h"
#include "project/edits/value_edits.h"
#include "project/objects/part_values.h"
#include "schema/value_words.h"

namespace trundle {

namespace {

constexpr double kOverFloor = 0.005, kOverTop = 0.02, kGrainOfPlace = 1e-3; // m
constexpr double kAsideOfMiddle = 0.25;                                     // of the width

bool isNeed(const Property& field) { return field.type == PropertyType::Text && !field.choices.empty(); }

bool meetsNeed(const Property& field, const ComponentSpec& device) {
    return std::ranges::any_of(field.choices, [&](const std::string& kind) { return portFits(kind, device.kind); });
}

/// The findings about the controllers of all robots; one for robots that lack the same.
class NeedsCheck {
public:
    NeedsCheck(const LoadedProject& loaded, Diagnostics& diagnostics) : m_loaded(loaded), m_diagnostics(diagnostics) {}

    void check() {
        for (const RobotSpec& robot : m_loaded.experiment->robots)
            for (const ControllerSpec& controller : robot.controllers)
                if (robot.config) check(robot, controller);
        for (const NeedFinding& finding : m_findings) report(finding);
    }

private:
    struct NeedFinding {
        const RobotSpec* robot;
        const ControllerSpec* controller;
        const Property* field;
        std::string device;
        std::size_t others = 0;
    };

    void check(const RobotSpec& robot, const ControllerSpec& controller) {
        const Kind* kind = m_loaded.registry->find(controller.kind);
        if (!kind) return;
        for (const Property& field : kind->properties)
            if (isNeed(field))
                for (const std::string& name : controller.texts(field.name))
                    if (!name.empty()) checkDevice(robot, controller, field, name);
    }

    void checkDevice(const RobotSpec& robot, const ControllerSpec& controller, const Property& field, const std::string& name) {
        const auto& devices = robot.config->devices;
        const auto found = std::ranges::find(devices, name, &ComponentSpec::name);
        if (found != devices.end() && meetsNeed(field, *found)) return;
        const auto [earlier, isFirst] =
            m_byConfig.try_emplace({robot.config->name, controller.kind, field.name, name}, m_findings.size());
        if (isFirst) m_findings.push_back({&robot, &controller, &field, name});
        else ++m_findings[earlier->second].others;
    }

    void report(const NeedFinding& finding) {
        const RobotSpec& robot = *finding.robot;
        const ControllerSpec& controller = *finding.controller;
        const ResolvedValue* value = controller.find(finding.field->name);
        const auto& devices = robot.config->devices;
        const auto other = std::ranges::find(devices, finding.device, &ComponentSpec::name);
        const std::string more = finding.others > 0 ? " (and " + std::to_string(finding.others) + " more like it)" : "";
        const std::string what = other != devices.end() ? ": " + finding.device + " is " + withArticle(other->kind) : "";
        Diagnostic& d = m_diagnostics.error(
            Code::UnknownPort, value && value->range.known() ? value->range : controller.nameRange,
            robot.name + " lacks the " + listText(finding.field->choices) + " '" + finding.device + "' that its controller " +
                controller.kind + " needs as its " + finding.field->name + what + more);
        d.notes.push_back({"of this robot", robot.nameRange});
        std::vector<std::string> fitting;
        for (const ComponentSpec& device : devices)
            if (meetsNeed(*finding.field, device) && !isNamed(controller, device.name)) fitting.push_back(device.name);
        if (fitting.empty() && other == devices.end()) addDevice(finding, d);
        if (fitting.size() == 1) nameDevice(finding, fitting.front(), d);
        d.suggestions = std::move(fitting);
    }

    /// Whether the controller has it already, for another of its needs.
    [[nodiscard]] bool isNamed(const ControllerSpec& controller, const std::string& device) const {
        const Kind* kind = m_loaded.registry->find(controller.kind);
        return kind && std::ranges::any_of(kind->properties, [&](const Property& field) {
                   const std::vector<std::string> names =
                       isNeed(field) ? controller.texts(field.name) : std::vector<std::string>();
                   return std::ranges::find(names, device) != names.end();
               });
    }

    /// Offers the only device that fits. A list of names is left to the user, since another of its elements may have it.
    void nameDevice(const NeedFinding& finding, const std::string& device, Diagnostic& d) const {
        if (finding.field->maxCount != 1) return;
        const std::optional<ObjectLocation> place = placeOf(m_loaded, finding.robot->name);
        if (!place || !place->part) return;
        const std::string& key = finding.field->name;
        const auto edits = editsForValues(
            m_loaded, {{DottedPath(place->part->name + "." + finding.controller->name + "." + key), device}});
        if (edits.ok() && edits.value().size() == 1) d.fixes.push_back({key + "=" + device, edits.value().begin()->second});
    }

    /// Offers to insert the smallest device of that kind, with the name that the controller looks for.
    void addDevice(const NeedFinding& finding, Diagnostic& d) const {
        const Kind* kind = m_loaded.registry->find(finding.field->choices.front());
        if (!kind || kind->role != Role::Device) return;
        std::string text = templateOf(m_loaded, *kind, finding.robot->name);
        const std::string opening = kind->name + " ";
        const std::size_t line = text.rfind('\n'), from = (line == std::string::npos ? 0 : line + 1) + opening.size();
        const std::size_t end = text.find(' ', from);
        if (text.compare(from - opening.size(), opening.size(), opening) != 0 || end == std::string::npos) return;
        text.replace(from, end - from, finding.device);
        placeDevice(*kind, finding.device, finding.robot->config->bodies.front(), text);
        const Result<EditPlan> plan = planInsert(m_loaded, finding.robot->name, text);
        if (plan.ok() && plan.value().edits.size() == 1)
            d.fixes.push_back({"add the " + kind->name + " " + finding.device + " to " + finding.robot->config->name,
                               plan.value().edits.begin()->second});
    }

    /// Where it can sense something: what looks at the floor low at the front, a lidar on top, others at the front; on the side of its name.
    static void placeDevice(const Kind& kind, const std::string& name, const BodySpec& body, std::string& text) {
        const auto has = [&](const char* key) {
            return std::ranges::find(kind.properties, key, &Property::name) != kind.properties.end();
        };
        const std::size_t close = text.rfind('}');
        if (!has("Body") || !has("Pos") || text.find(" Pos=") != std::string::npos || close == std::string::npos ||
            body.geoms.empty())
            return;
        const auto [low, high] = boxAround(body);
        const Vec3 middle = (low + high) / 2;
        Vec3 at(high.x(), middle.y(), middle.z());
        if (name.starts_with("left")) at.y() += kAsideOfMiddle * (high.y() - low.y());
        if (name.starts_with("right")) at.y() -= kAsideOfMiddle * (high.y() - low.y());
        if (kind.name == "GroundSensor") at.z() = low.z() + kOverFloor;
        if (kind.name == "Lidar") at = Vec3(middle.x(), middle.y(), high.z() + kOverTop);
        for (int k = 0; k < 3; ++k) at[k] = std::round(at[k] / kGrainOfPlace) * kGrainOfPlace + 0.;
        text.insert(close, "Pos=" + positionText(at) + " ");
    }

    const LoadedProject& m_loaded;
    Diagnostics& m_diagnostics;
    std::vector<NeedFinding> m_findings;
    /// By config, controller, field and device.
    std::map<std::tuple<std::string, std::string, std::string, std::string>, std::size_t> m_byConfig;
};

} // namespace

void checkNeeds(const LoadedProject& loaded, Diagnostics& diagnostics) { NeedsCheck(loaded, diagnostics).check(); }

} // namespace trundle
