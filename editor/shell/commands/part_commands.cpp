#include "editor/shell/commands/part_commands.h"

#include <algorithm>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/document/structure_edits.h"
#include "editor/shell/dialogs/repeat_dialog.h"
#include "editor/shell/dialogs/sensor_ring_dialog.h"
#include "editor/widgets/actions.h"
#include "editor/widgets/strings.h"
#include "model/dotted_path.h"
#include "project/edits/insert_positions.h"
#include "project/edits/plan_wrap.h"
#include "project/edits/repeat_step.h"
#include "schema/allowed_parents.h"

namespace trundle {
namespace {

/// Whether a path leads to a block inside of a config: what is placed at the top level is no part of anything.
bool isInConfig(const LoadedProject& loaded, const std::string& path) {
    const auto place = placeOf(loaded, definedAt(loaded, path));
    return place && place->part && !place->above.empty() && place->above.front()->is(Role::Config);
}

/// Robots and scenery at the top level can be repeated too, but no configs and materials.
bool isRepeatable(const LoadedProject& loaded, const std::string& path) {
    if (isInConfig(loaded, path)) return true;
    const auto place = placeOf(loaded, path);
    const Kind* kind = place && place->part ? place->part->kind : nullptr;
    return kind && isAllowedInside(*kind, "Repeat");
}

} // namespace

PartCommands::PartCommands(QWidget& window, Actions& actions, Document& document, Selection& selection)
    : QObject(&window), m_window(window), m_actions(actions), m_document(document), m_selection(selection) {
    connect(&actions.at("parts.make"), &QAction::triggered, this, [this] { apply(tr("Make Part of %1"), planMakePart); });
    for (const auto& [id, axis] :
         {std::pair{"parts.mirrorY", 'y'}, std::pair{"parts.mirrorX", 'x'}, std::pair{"parts.mirrorZ", 'z'}})
        connect(&actions.at(id), &QAction::triggered, this, [this, axis = axis] {
            apply(tr("Mirror %1"), [axis](const LoadedProject& loaded, const std::vector<std::string>& paths) {
                return planMirror(loaded, paths, axis);
            });
        });
    connect(&actions.at("parts.repeat"), &QAction::triggered, this, &PartCommands::askRepeat);
    connect(&selection, &Selection::changed, this, &PartCommands::enable);
    connect(&document, &Document::changed, this, &PartCommands::enable);
    connect(&actions.at("sensors.ring"), &QAction::triggered, this, &PartCommands::askSensorRing);
}

/// Without a selection they say what to select.
void PartCommands::enable() {
    const std::vector<std::string> paths = m_document.isOpen() ? m_selection.paths() : std::vector<std::string>();
    const auto isAny = [&](bool (*isPossible)(const LoadedProject&, const std::string&)) {
        return paths.empty() || std::ranges::any_of(paths, [&](const std::string& path) {
                   return path.empty() || isPossible(*m_document.loaded(), path);
               });
    };
    const bool isInside = isAny(isInConfig);
    for (const char* id : {"parts.make", "parts.mirrorY", "parts.mirrorX", "parts.mirrorZ"})
        m_actions.at(id).setEnabled(isInside);
    m_actions.at("parts.repeat").setEnabled(isAny(isRepeatable));
}

std::vector<std::string> PartCommands::chosen() {
    std::vector<std::string> paths;
    if (m_document.isOpen()) paths = m_selection.paths();
    std::erase(paths, std::string());
    if (paths.empty()) Q_EMIT m_document.refused(tr("select bodies, joints or other parts of a robot or of scenery first"));
    return paths;
}

void PartCommands::apply(const QString& name, const Plan& plan) {
    const std::vector<std::string> paths = chosen();
    if (paths.empty()) return;
    const QString objects =
        paths.size() == 1 ? toQString(std::string(lastWord(paths.front()))) : tr("%1 objects").arg(paths.size());
    (void)m_document.structure().apply(name.arg(objects), paths,
                                       [paths, plan](const LoadedProject& loaded, const StructureEdits::PathMapping& renamed) {
                                           std::vector<std::string> now;
                                           for (const std::string& path : paths) now.push_back(renamed(path));
                                           return plan(loaded, now);
                                       });
}

void PartCommands::askRepeat() {
    const std::vector<std::string> paths = chosen();
    if (paths.empty()) return;
    const LoadedProject& loaded = *m_document.loaded();
    // Reported before numbers are chosen for it; which numbers makes no difference.
    const Result<EditPlan> possible = planRepeat(loaded, paths, 2, Vec3::Zero());
    if (!possible) return Q_EMIT m_document.refused(toQString(possible.error().message));
    auto* dialog = new RepeatDialog(repeatStep(loaded, paths), &m_window);
    connect(&m_document, &Document::opened, dialog, &QDialog::reject);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        apply(tr("Repeat %1"),
              [count = dialog->count(), step = dialog->step()](const LoadedProject& now, const std::vector<std::string>& what) {
                  return planRepeat(now, what, count, step);
              });
    });
    dialog->open();
}

void PartCommands::askSensorRing() {
    if (!m_document.isOpen()) return Q_EMIT m_document.refused(tr("nothing is open"));
    const LoadedProject& loaded = *m_document.loaded();
    const Result<std::string> body = bodyForSensors(loaded, m_selection.current());
    if (!body) return Q_EMIT m_document.refused(toQString(body.error().message));
    const std::string path = body.value();
    auto* dialog = new SensorRingDialog(toQString(std::string(lastWord(path))), proposedRing(loaded, path), &m_window);
    connect(&m_document, &Document::opened, dialog, &QDialog::reject);
    connect(dialog, &QDialog::accepted, this, [this, dialog, path] {
        (void)m_document.structure().apply(
            tr("Add Ring of Sensors"), {path},
            [path, ring = dialog->ring()](const LoadedProject& now, const StructureEdits::PathMapping& renamed) {
                return planSensorRing(now, renamed(path), ring);
            });
    });
    dialog->open();
}

} // namespace trundle
