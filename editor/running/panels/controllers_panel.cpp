#include "editor/running/panels/controllers_panel.h"

#include <algorithm>

#include <QAction>
#include <QClipboard>
#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QScrollArea>
#include <QSplitter>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>

#include "control/isolation.h"
#include "control/python_kinds.h"
#include "editor/document/selection.h"
#include "editor/document/structure_edits.h"
#include "editor/running/panels/controller_commands.h"
#include "editor/running/panels/controller_details.h"
#include "editor/running/panels/controller_dialogs.h"
#include "editor/running/panels/panel_table.h"
#include "editor/running/panels/module_reload.h"
#include "editor/running/panels/robot_states.h"
#include "editor/widgets/actions.h"
#include "editor/widgets/controls.h"
#include "editor/widgets/plain_text.h"
#include "editor/widgets/strings.h"
#include "editor/widgets/theme.h"

namespace trundle {
namespace {

enum Column { kRobot, kController, kState, kMean, kWorst, kLastCall, kRestarts }; ///< of the robots

/// As the block of the controller says; the setting of the experiment is not considered.
bool isIsolated(const LoadedProject& loaded, const ControlledRobot& robot) {
    const RobotSpec* first = firstRobotOf(*loaded.experiment, *loaded.outline, robot);
    const ControllerSpec* controller = first ? controllerIn(*first, robot) : nullptr;
    return controller && isolationOf(*controller, {}, Isolation::Module) == Isolation::Robot;
}

QToolButton* textButton(const char* name, const QString& text, const QString& tip, const char* icon = "") {
    auto* made = new QToolButton;
    made->setObjectName(QLatin1String(name));
    made->setText(text);
    made->setIcon(themedIcon(QLatin1String(icon)));
    made->setToolTip(tip);
    showTextBesideIcon(*made);
    made->setAutoRaise(true);
    return made;
}

/// A tool button with a short text; menus show the action's full text, since they lack the context of the panel.
QToolButton* actionButton(QAction& action, const QString& text) {
    action.setIconText(text);
    auto* made = new QToolButton;
    made->setDefaultAction(&action);
    showTextBesideIcon(*made);
    made->setAutoRaise(true);
    return made;
}

/// What is needed less often for the selected robots.
QToolButton* moreButton(Actions& actions) {
    QToolButton* more =
        textButton("controllersMore", QStringLiteral("…"), ControllersPanel::tr("More for the selected robots"));
    more->setAccessibleName(more->toolTip());
    more->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(more);
    for (const char* action : {"controllers.stop", "controllers.remove", "controllers.isolate", "controllers.debug"})
        menu->addAction(&actions.at(action));
    more->setMenu(menu);
    return more;
}

/// Without a dock title: the list's header describes it, and the title's room is needed for the buttons.
QWidget* withTools(QTreeWidget* list, const QList<QWidget*>& tools) {
    auto* box = new QWidget;
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(4, 3, 4, 3);
    row->setSpacing(2);
    for (QWidget* tool : tools) row->addWidget(tool);
    row->addStretch(1);
    column->addLayout(row);
    column->addWidget(list, 1);
    return box;
}

} // namespace

ControllersPanel::ControllersPanel(Document& document, Selection& selection, RunSession& session, Actions& actions,
                                   QWidget* parent)
    : QWidget(parent), m_document(document), m_selection(selection), m_session(session), m_actions(actions),
      m_commands(new ControllerCommands(document, session, this)) {
    setObjectName(QStringLiteral("ControllersPanel"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_notice = new QLabel(this);
    m_notice->setObjectName(QStringLiteral("controllersNotice"));
    m_notice->setWordWrap(true);
    m_notice->setContentsMargins(8, 6, 8, 6);
    m_notice->hide();
    column->addWidget(m_notice);
    auto* scroll = new QScrollArea(this); // for narrow windows: no part gets less than it needs
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setFocusPolicy(Qt::NoFocus);
    auto* halves = new QSplitter(Qt::Horizontal);
    halves->setChildrenCollapsible(false);
    halves->addWidget(makeModules());
    halves->addWidget(makeRobots());
    m_details = new ControllerDetails(session, this);
    halves->addWidget(m_details);
    halves->setCollapsible(2, true);
    for (int half : {0, 1, 2}) halves->setStretchFactor(half, half == 1 ? 3 : 2);
    scroll->setWidget(halves);
    column->addWidget(scroll, 1);

    m_commands->setAsk([this](const QString& library, const QString& folder) { return askForTrust(library, folder, this); });
    connect(m_commands, &ControllerCommands::refused, this, &ControllersPanel::refused);
    connect(&document, &Document::changed, this, &ControllersPanel::refresh);
    connect(&document, &Document::opened, this, [this] {
        refresh();
        if (!m_notice->isHidden()) Q_EMIT attentionRequested();
    });
    connect(&session, &RunSession::stateChanged, this, &ControllersPanel::showStates);
    connect(&session, &RunSession::stateChanged, this, &ControllersPanel::showButtons);
    connect(&session.messages(), &RunMessages::problemsChanged, this, &ControllersPanel::showStates);
    connect(&session, &RunSession::advanced, this, &ControllersPanel::showStopped);
    connect(&session.robots().ended(), &EndedRobots::changed, this, &ControllersPanel::showStates);
    connect(&selection, &Selection::changed, this, &ControllersPanel::showButtons);
    connectActions();
    refresh();
}

QWidget* ControllersPanel::makeModules() {
    m_modules = panelTable("moduleList", {tr("Module"), tr("Kinds"), tr("SDK"), tr("Library")});
    QHeaderView& header = *m_modules->header();
    header.setStretchLastSection(false);
    for (const int column : {0, 1, 2}) header.setSectionResizeMode(column, QHeaderView::ResizeToContents);
    header.setSectionResizeMode(3, QHeaderView::Stretch);
    QToolButton* load = actionButton(m_actions.at("controllers.load"), tr("Load…"));
    load->setObjectName(QStringLiteral("moduleLoad"));
    m_recent = new QMenu(tr("Load R&ecent"), load);
    load->setMenu(m_recent);
    load->setPopupMode(QToolButton::MenuButtonPopup);
    connect(m_recent, &QMenu::aboutToShow, this, &ControllersPanel::showRecent);
    m_unload = textButton("moduleUnload", tr("Unload"), tr("Remove the line that loads the module from the text"));
    m_trust = textButton("moduleTrust", tr("Trust…"), tr("Allow the modules of this folder to run"));
    QToolButton* reload = actionButton(m_actions.at("controllers.reload"), tr("Reload"));
    connect(m_unload, &QToolButton::clicked, this, [this] {
        if (const ModuleInfo* module = currentModule()) m_commands->unload(ModuleInfo(*module));
    });
    connect(m_trust, &QToolButton::clicked, this, [this] {
        if (const ModuleInfo* module = currentModule()) m_commands->trust(ModuleInfo(*module));
    });
    connect(m_modules, &QTreeWidget::currentItemChanged, this, &ControllersPanel::showButtons);
    connect(m_modules, &QTreeWidget::itemActivated, this, [this] {
        const ModuleInfo* module = currentModule();
        if (module && module->range.known()) Q_EMIT jumpTo(m_document.texts().files().at(module->range.file), module->range);
    });
    return withTools(m_modules, {load, reload, m_unload, m_trust});
}

QWidget* ControllersPanel::makeRobots() {
    m_robots = panelTable("robotControllers", {tr("Robot"), tr("Controller"), tr("State"), tr("Mean"), tr("Worst"), tr("Last call"), tr("Restarts")});
    const QStringList tips{tr("Mean time of a call, on this machine"), tr("The longest call, on this machine"),
                           tr("How long ago the last call was, in simulated time"), tr("How often it was started again in this run")};
    for (int column = kMean; column <= kRestarts; ++column) m_robots->headerItem()->setToolTip(column, tips[column - kMean]);
    m_robots->setSelectionMode(QAbstractItemView::ExtendedSelection);
    for (const int column : {0, 1, 2, 3, 4, 5}) m_robots->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    m_robots->header()->setResizeContentsPrecision(0); // measures only visible rows, since a swarm has many
    connect(m_robots, &QTreeWidget::itemSelectionChanged, this, [this] {
        std::vector<std::string> paths;
        for (const QTreeWidgetItem* item : m_robots->selectedItems())
            paths.push_back(item->data(0, Qt::UserRole).toString().toStdString());
        if (paths.empty()) return;
        m_choosing = true;
        m_selection.set(std::move(paths));
        m_choosing = false;
    });
    connect(m_robots, &QTreeWidget::itemActivated, this, [this] { assignTo(chosenRobots()); });
    QToolButton* restart = actionButton(m_actions.at("controllers.restart"), tr("Restart"));
    restart->setToolButtonStyle(Qt::ToolButtonIconOnly); // for narrow windows, as is the menu
    return withTools(m_robots, {actionButton(m_actions.at("controllers.assign"), tr("Assign…")), restart, moreButton(m_actions)});
}

void ControllersPanel::connectActions() {
    connect(&m_actions.at("controllers.load"), &QAction::triggered, this, &ControllersPanel::loadByDialog);
    connect(&m_actions.at("controllers.assign"), &QAction::triggered, this, [this] { assignTo(chosenRobots()); });
    connect(&m_actions.at("controllers.remove"), &QAction::triggered, this, [this] { m_commands->unassign(chosenRobots()); });
    connect(&m_actions.at("controllers.restart"), &QAction::triggered, this,
            [this] { m_session.robots().restartControllers(controlledMembers()); });
    connect(&m_actions.at("controllers.stop"), &QAction::triggered, this,
            [this] { m_session.robots().stopControllers(controlledMembers()); });
    connect(&m_actions.at("controllers.isolate"), &QAction::triggered, this, &ControllersPanel::isolate);
    connect(&m_actions.at("controllers.debug"), &QAction::triggered, this, &ControllersPanel::copyDebuggerCommand);
    auto* numbers = new QTimer(this);
    numbers->setInterval(250);
    connect(numbers, &QTimer::timeout, this, &ControllersPanel::showNumbers);
    numbers->start();
    connect(&m_actions.at("controllers.reload"), &QAction::triggered, m_commands, &ControllerCommands::reload);
    new ModuleReload(m_session, m_actions.at("controllers.follow"), this);
}

std::vector<std::string> ControllersPanel::chosenRobots() const {
    return m_document.loaded() ? robotsAmong(*m_document.loaded(), m_selection.paths()) : std::vector<std::string>();
}

/// The chosen controllers of the run, as "robot/controller", with those of the members of Grids and Scatters.
std::vector<std::string> ControllersPanel::controlledMembers() const {
    std::vector<std::string> names;
    const RunResults& results = m_session.results();
    const std::vector<std::string> chosen = chosenRobots();
    for (const ControlledRobot& row : m_listed) {
        if (!row.isAmong(chosen)) continue;
        for (const RobotSpec& robot : results.experiment ? results.experiment->robots : std::vector<RobotSpec>())
            if (const ControllerSpec* controller = isRobotOf(m_session, robot.name, row) ? controllerIn(robot, row) : nullptr)
                names.push_back(robot.name + "/" + controller->name);
    }
    return names;
}

const ModuleInfo* ControllersPanel::currentModule() const {
    const int row = m_modules->indexOfTopLevelItem(m_modules->currentItem());
    return row >= 0 && row < static_cast<int>(m_infos.size()) ? &m_infos[static_cast<std::size_t>(row)] : nullptr;
}

void ControllersPanel::assignTo(const std::vector<std::string>& robots) {
    if (robots.empty()) {
        Q_EMIT refused(tr("Select the robots that shall have the controller."));
        return;
    }
    const std::vector<ControllerChoice> choices = m_commands->choices();
    if (const int chosen = chooseController(choices, robots, this); chosen >= 0)
        m_commands->assign(robots, choices[static_cast<std::size_t>(chosen)]);
}

void ControllersPanel::loadByDialog() {
    const QString start = m_document.isOpen() ? QFileInfo(QString::fromStdString(m_document.path())).absolutePath() : QString();
    const QString library = QFileDialog::getOpenFileName(this, tr("Load Module"), start, tr("Modules (*.so);;All files (*)"));
    if (!library.isEmpty()) m_commands->load(library);
}

void ControllersPanel::showRecent() {
    m_recent->clear();
    for (const QString& library : ControllerCommands::recent()) {
        QAction* action = m_recent->addAction(withoutMnemonics(QFileInfo(library).fileName()), this,
                                              [this, library] { m_commands->load(library); });
        action->setToolTip(library);
    }
    if (m_recent->isEmpty()) m_recent->addAction(tr("No module was loaded yet"))->setEnabled(false);
    m_recent->setToolTipsVisible(true);
}

// ---- display ----

void ControllersPanel::refresh() {
    refreshModules();
    refreshRobots();
    showButtons();
}

void ControllersPanel::refreshModules() {
    m_infos = m_commands->modules();
    const QSignalBlocker quiet(m_modules);
    const int row = m_modules->indexOfTopLevelItem(m_modules->currentItem());
    m_modules->clear();
    QStringList untrusted;
    for (const ModuleInfo& info : m_infos) {
        QStringList kinds;
        for (const std::string& kind : info.kinds) kinds.append(QString::fromStdString(kind));
        const QString library = QString::fromStdString(info.library);
        auto* item = new QTreeWidgetItem(
            m_modules, {QString::fromStdString(info.written), kinds.join(QStringLiteral(", ")), info.version,
                        info.trouble.isEmpty() ? toQString(m_document.texts().shown(info.library)) : info.trouble});
        const QString all = toQString(info.written) + QStringLiteral(": ") + kinds.join(QStringLiteral(", ")) + u'\n' + library;
        for (int column = 0; column < 4; ++column)
            item->setToolTip(column, info.trouble.isEmpty() ? all : info.trouble + u'\n' + library);
        item->setData(3, kIsPathRole, info.trouble.isEmpty());
        if (!info.trouble.isEmpty()) item->setForeground(3, ink(info.trusted ? Ink::Error : Ink::Warning));
        if (!info.trusted) untrusted.append(QString::fromStdString(info.written));
    }
    if (m_modules->topLevelItemCount() > 0)
        m_modules->setCurrentItem(m_modules->topLevelItem(std::clamp(row, 0, m_modules->topLevelItemCount() - 1)));
    if (m_notice->isHidden() && !untrusted.isEmpty()) { // newly shown: Trust… must refer to the module in the notice
        const auto first = std::ranges::find(m_infos, false, &ModuleInfo::trusted) - m_infos.begin();
        m_modules->setCurrentItem(m_modules->topLevelItem(static_cast<int>(first)));
    }
    m_notice->setVisible(!untrusted.isEmpty());
    m_notice->setText(tr("This experiment asks for code from a folder that you have not trusted: %1. None of it has run. "
                         "Choose the module and Trust… "
                         "if you know where it comes from.")
                          .arg(untrusted.join(QStringLiteral(", "))));
    const QString colour = QStringLiteral("QLabel { color: %1; }").arg(ink(Ink::Warning).name());
    if (colour != m_notice->styleSheet()) m_notice->setStyleSheet(colour);
}

void ControllersPanel::refreshRobots() {
    m_listed = m_document.loaded() ? controlledRobots(*m_document.loaded()) : std::vector<ControlledRobot>();
    const QSignalBlocker quiet(m_robots);
    m_robots->clear();
    m_stale = !isVisible(); // the rows of a swarm take longer than the edit, so they are created when the panel is shown
    if (m_stale) return;
    for (const ControlledRobot& robot : m_listed) {
        const QString name = toQString(robot.controllers > 1 ? robot.path + " · " + robot.controller : robot.path);
        const QString shown = robot.members == 1 ? name : tr("%1 (%2 robots)").arg(name, QString::number(robot.members));
        auto* item = new QTreeWidgetItem(
            m_robots, {shown, robot.kind.empty() ? QStringLiteral("–") : QString::fromStdString(robot.kind), QString()});
        item->setData(0, Qt::UserRole, toQString(robot.target()));
        for (int column = kMean; column <= kRestarts; ++column) item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
        item->setSelected(m_selection.contains(robot.path) || m_selection.contains(robot.target()));
    }
    showStates();
}

void ControllersPanel::showStates() {
    const ChangedTogether changes(*m_robots);
    for (std::size_t i = 0; i < m_listed.size() && !m_stale; ++i) {
        const ControllerState state = controllerState(m_session, m_listed[i]);
        QTreeWidgetItem* item = m_robots->topLevelItem(static_cast<int>(i));
        item->setText(kState, state.text);
        item->setToolTip(kState, state.detail.isEmpty() ? state.text : state.detail);
        item->setForeground(kState, ink(state.failed ? Ink::Error : state.active ? Ink::Good : Ink::Faint));
    }
}

/// Several times a second while it is visible: the values change in every tick.
void ControllersPanel::showNumbers() {
    if (!isVisible() || m_stale) return;
    const RunResults& results = m_session.results();
    const double now = results.snapshot ? results.snapshot->time : 0;
    const ChangedTogether changes(*m_robots);
    for (int i = 0; i < m_robots->topLevelItemCount(); ++i) {
        const ControllerNumbers numbers = controllerNumbers(m_session, m_listed[static_cast<std::size_t>(i)]);
        const bool called = numbers.calls > 0;
        const QStringList texts{called ? callTimeText(numbers.meanS) : QString(), called ? callTimeText(numbers.worstS) : QString(),
                                called ? tr("%1 s ago").arg(std::max(0.0, now - numbers.lastCall), 0, 'f', 2) : QString(),
                                numbers.isKnown ? QString::number(numbers.restarts) : QString()};
        for (int column = kMean; column <= kRestarts; ++column) m_robots->topLevelItem(i)->setText(column, texts[column - kMean]);
    }
}

/// The first chosen robot that has a controller.
const ControlledRobot* ControllersPanel::chosenController() const {
    const std::vector<std::string> chosen = chosenRobots();
    const auto found = std::ranges::find_if(
        m_listed, [&](const ControlledRobot& robot) { return !robot.kind.empty() && robot.isAmong(chosen); });
    return found == m_listed.end() ? nullptr : &*found;
}

/// Sets or resets the property of the controllers' blocks, as one edit.
void ControllersPanel::isolate(bool alone) {
    std::vector<ValueEdit> values;
    const std::vector<std::string> chosen = chosenRobots();
    for (const ControlledRobot& robot : m_listed)
        if (!robot.kind.empty() && robot.isAmong(chosen))
            values.push_back({robot.path + "." + robot.controller + ".Isolation", alone ? "robot" : "module"});
    if (values.empty()) return Q_EMIT refused(tr("Select a robot with a controller."));
    (void)m_document.structure().setValues(alone ? tr("Isolate Controller") : tr("Share the Process of the Module"), values);
    showButtons(); // also after a refusal, which the document reports
}

void ControllersPanel::copyDebuggerCommand() {
    const ControlledRobot* robot = chosenController();
    const ControllerNumbers numbers = robot ? controllerNumbers(m_session, *robot) : ControllerNumbers();
    if (!numbers.isKnown) return Q_EMIT refused(tr("Start a run and select a robot with a controller: a debugger attaches to its process."));
    if (numbers.process == 0)
        return Q_EMIT refused(tr("This controller has no process of its own, or that has ended; set Isolation = module."));
    const Kind* kind = m_document.loaded()->registry->find(robot->kind);
    const QString command = kind && isPythonModule(kind->module) ? QStringLiteral("py-spy dump --pid %1") : QStringLiteral("gdb -p %1");
    QGuiApplication::clipboard()->setText(command.arg(numbers.process));
    Q_EMIT refused(tr("Copied: %1").arg(command.arg(numbers.process)));
}

/// A restart removes stopped controllers without a message.
void ControllersPanel::showStopped() {
    const auto& snapshot = m_session.results().snapshot;
    if (const std::size_t stopped = snapshot ? snapshot->stopped.size() : 0; std::exchange(m_stopped, stopped) != stopped) showStates();
}

void ControllersPanel::showButtons() {
    const ModuleInfo* module = currentModule();
    m_unload->setEnabled(module != nullptr);
    m_trust->setVisible(module && !module->trusted);
    const std::vector<std::string> robots = chosenRobots();
    m_actions.at("controllers.load").setEnabled(m_document.isOpen());
    m_actions.at("controllers.reload").setEnabled(m_document.isOpen());
    m_actions.at("controllers.assign").setEnabled(!robots.empty());
    const ControlledRobot* chosen = chosenController();
    const bool any = chosen != nullptr;
    m_actions.at("controllers.remove").setEnabled(any);
    const RunState state = m_session.state();
    const bool runs = state == RunState::Running || state == RunState::Paused;
    for (const char* id : {"controllers.restart", "controllers.stop", "controllers.debug"}) m_actions.at(id).setEnabled(any && runs);
    m_actions.at("controllers.isolate").setEnabled(any);
    m_actions.at("controllers.isolate").setChecked(chosen && isIsolated(*m_document.loaded(), *chosen));
    m_details->show(chosen ? *chosen : ControlledRobot());
    if (m_choosing) return;
    const QSignalBlocker quiet(m_robots);
    for (int i = 0; i < m_robots->topLevelItemCount(); ++i)
        m_robots->topLevelItem(i)->setSelected(m_listed[static_cast<std::size_t>(i)].isAmong(robots));
}

void ControllersPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (m_stale) refresh();
}

void ControllersPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_robots) refresh();
}

} // namespace trundle
