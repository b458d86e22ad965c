#include "editor/shell/commands/model_commands.h"

#include <algorithm>
#include <utility>

#include <QActionGroup>
#include <QFile>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/outline/block_mime.h"
#include "editor/outline/object_edits.h"
#include "editor/running/run_source.h"
#include "editor/running/session.h"
#include "editor/shell/layouts.h"
#include "editor/shell/status_line.h"
#include "editor/shell/work_area.h"
#include "editor/viewport/view/viewport_panel.h"
#include "editor/widgets/resources.h"
#include "editor/widgets/strings.h"
#include "model/dotted_path.h"
#include "model/name_walk.h"
#include "project/objects/object_location.h"

namespace trundle {
namespace {

constexpr std::size_t kMostSearched = 20'000; ///< blocks in Parts

const Part* partConfigOf(const LoadedProject& loaded, const std::string& selected) {
    const auto place = placeOf(loaded, selected);
    const Part* top = place ? topOf(*place) : nullptr;
    return top && top->kind && top->kind->name == "PartConfig" ? top : nullptr;
}

/// The first Part in a model that is made from a PartConfig: "RobotConfig.Kit.left"; empty: no model has one.
std::string useOf(const Document& document, const Part& partConfig) {
    std::string use;
    for (const Part* config : document.loaded()->outline->configs.all()) {
        const std::string model = pathOfConfig(*config);
        if (document.editedModel().modelOf(model).empty()) continue;
        NameWalk(kMostSearched).inside(*config, model + ".", [&](const Part& part, const std::string& prefix) {
            if (use.empty() && part.isPartUse() && part.config == &partConfig) use = prefix + part.name;
            return use.empty() && !part.is(Role::Body);
        });
        if (!use.empty()) break;
    }
    return use;
}

/// The path of a selected object in a model, "RobotConfig.Kit.left.wheel" of "robot0.left.wheel"; of what is in a PartConfig that of
/// the innermost Part that has it. Empty: it is not in the model.
std::string pathInModel(const Document& document, const std::string& selected, const std::string& model) {
    const LoadedProject& loaded = *document.loaded();
    if (startsWithPath(selected, model)) return selected;
    if (const Part* part = partConfigOf(loaded, selected)) {
        const std::string use = useOf(document, *part);
        if (!startsWithPath(use, model)) return {};
        const auto isPart = [&](const std::string& path) {
            const auto place = placeOf(loaded, path);
            return place && place->part && place->part->isPartUse();
        };
        std::string path = use + selected.substr(pathOfConfig(*part).size());
        while (path.size() > use.size() && !isPart(path)) path = withoutLastWord(path);
        return path;
    }
    const auto place = placeOf(loaded, selected);
    if (!place || place->within.empty() || document.editedModel().modelOf(selected) != model) return {};
    const std::string path = pathInside(model, place->within);
    return placeOf(loaded, path) ? path : std::string(); // a controller is not in the config
}

} // namespace

ModelCommands::ModelCommands(QWidget& window, Actions& actions, const Targets& targets)
    : QObject(&window), m_actions(actions), m_targets(targets) {
    connect(&m_actions.at("model.edit"), &QAction::triggered, this, &ModelCommands::edit);
    connect(&m_actions.at("model.new"), &QAction::triggered, this, &ModelCommands::makeNew);
    connect(&m_actions.at("model.drive"), &QAction::triggered, this, &ModelCommands::drive);
    offerGrounds();
    connect(&m_targets.document.editedModel(), &EditedModel::changed, this, &ModelCommands::showState);
    connect(&m_targets.session, &RunSession::stateChanged, this, [this] {
        if (m_driving && m_targets.session.state() == RunState::Start) endDrive(); // reset, or the model was closed
    });
}

/// The model of what is selected; without a selection that of the only robot or scenery that has one.
std::string ModelCommands::wanted() const {
    const EditedModel& model = m_targets.document.editedModel();
    if (model.isOpen()) return model.path();
    const std::string selected = m_targets.selection.current();
    if (const std::string path = model.modelOf(selected); !path.empty()) return path;
    if (const Part* part = partConfigOf(*m_targets.document.loaded(), selected)) // a Part is shown in a model that has it
        return model.modelOf(useOf(m_targets.document, *part));
    std::vector<std::string> all;
    for (const Part* config : m_targets.document.loaded()->outline->configs.all())
        if (const std::string path = model.modelOf(pathOfConfig(*config)); path.starts_with("RobotConfig.")) all.push_back(path);
    return all.size() == 1 ? all.front() : std::string();
}

bool ModelCommands::open(const std::string& path) {
    const LoadedProject& loaded = *m_targets.document.loaded();
    const Part* part = partConfigOf(loaded, m_targets.selection.current());
    if (path.empty()) {
        m_targets.status.refuse(
            part ? tr("No robot or scenery has a Part of %1 yet; insert one to see it.").arg(toQString(part->name))
                 : tr("Select the robot or scenery whose model you want to edit."));
        return false;
    }
    std::vector<std::string> inside;
    for (const std::string& selected : m_targets.selection.paths())
        if (std::string at = pathInModel(m_targets.document, selected, path); !at.empty()) inside.push_back(std::move(at));
    m_targets.document.editedModel().open(path);
    m_targets.selection.set(inside.empty() ? std::vector<std::string>{path} : inside);
    m_targets.work.showViewport(true);
    m_targets.layouts.raise(QStringLiteral("library"));
    m_targets.viewport.views().current().setFocus();
    return true;
}

void ModelCommands::edit(bool on) {
    EditedModel& model = m_targets.document.editedModel();
    if (on && m_targets.document.isOpen()) (void)open(wanted());
    else model.close();
    showState(); // also after a refusal
}

/// A config with a chassis to build on, and an instance of it.
void ModelCommands::makeNew() {
    QFile file(resourcePath(QStringLiteral("templates/model.sim")));
    if (!m_targets.document.isOpen() || !file.open(QIODevice::ReadOnly)) return;
    const Result<Blocks> blocks = blocksFrom(file.readAll().toStdString());
    if (!blocks || !m_targets.objects.insert(blocks.value(), {}, tr("New Robot Model"))) return;
    for (const std::string& path : m_targets.selection.paths())
        if (const std::string model = m_targets.document.editedModel().modelOf(path); !model.empty()) return (void)open(model);
}

void ModelCommands::drive(bool on) {
    if (!on) return m_targets.session.reset();
    const bool isOpen = m_targets.document.editedModel().isOpen();
    if (!m_targets.document.isOpen() || !open(wanted())) return showState();
    m_opened = !isOpen;
    m_targets.session.reset();
    m_targets.session.source().setRamp(m_ramp);
    m_targets.session.run(); // reports why it cannot
    if (m_targets.session.state() == RunState::Start) {
        m_targets.session.source().setRamp(0);
        if (m_opened) m_targets.document.editedModel().close();
        return showState();
    }
    m_driving = true;
    m_views = m_targets.viewport.views().viewStates();
    showSensors();
    m_drove = m_actions.at("sim.drive").isChecked();
    m_actions.at("sim.drive").setChecked(true);
    m_targets.viewport.views().current().setFocus();
    showState();
}

void ModelCommands::endDrive() {
    m_driving = false;
    hideSensors();
    ViewGrid& views = m_targets.viewport.views();
    if (m_targets.document.editedModel().isOpen()) views.setViewStates(m_views, views.viewCount()); // it followed the robot
    m_targets.session.source().setRamp(0);
    m_actions.at("sim.drive").setChecked(m_drove);
    if (std::exchange(m_opened, false)) m_targets.document.editedModel().close();
    showState();
}

/// What cameras and range sensors see, and all readings in the Sensors panel.
void ModelCommands::showSensors() {
    for (const char* overlay : {"view.overlayFrusta", "view.overlayBeams"})
        if (QAction& action = m_actions.at(overlay); !action.isChecked()) {
            action.trigger();
            m_shownForDrive.push_back(&action);
        }
    m_raisedSensors = m_targets.layouts.dock(QStringLiteral("sensors"))->isHidden();
    m_front = m_targets.layouts.raiseOver(QStringLiteral("sensors"));
}

void ModelCommands::hideSensors() {
    for (QAction* overlay : std::exchange(m_shownForDrive, {}))
        if (overlay->isChecked()) overlay->trigger();
    const QString sensors = QStringLiteral("sensors"), before = std::exchange(m_front, {});
    const bool isInFront = m_targets.layouts.isInFront(sensors); // else the user has chosen another one
    if (std::exchange(m_raisedSensors, false)) m_targets.layouts.dock(sensors)->hide();
    if (isInFront && !before.isEmpty()) m_targets.layouts.raise(before);
}

void ModelCommands::offerGrounds() {
    auto* group = new QActionGroup(this);
    struct Ground {
        const char* id;
        double slope;
    };
    for (const Ground ground :
         {Ground{"drive.floor", 0}, {"drive.ramp5", 5}, {"drive.ramp10", 10}, {"drive.ramp20", 20}, {"drive.ramp30", 30}}) {
        QAction& action = m_actions.at(ground.id);
        group->addAction(&action);
        action.setChecked(ground.slope == m_ramp);
        connect(&action, &QAction::triggered, this, [this, ground] { setRamp(ground.slope); });
    }
}

/// A drive begins anew on the new ground.
void ModelCommands::setRamp(double slope) {
    const bool isDriving = m_driving;
    m_ramp = slope;
    if (!isDriving) return;
    drive(false);
    drive(true);
}

void ModelCommands::showState() {
    m_actions.at("model.edit").setChecked(m_targets.document.editedModel().isOpen());
    m_actions.at("model.drive").setChecked(m_driving);
}

} // namespace trundle
