#include "editor/shell/main_window.h"

#include <algorithm>

#include <QApplication>
#include <QCloseEvent>
#include <QScreen>
#include <QSettings>
#include <QStatusBar>
#include <QToolBar>

#include "editor/cameras/cameras_panel.h"
#include "editor/document/history_panel.h"
#include "editor/outline/insert_menu.h"
#include "editor/outline/library_panel.h"
#include "editor/outline/object_edits.h"
#include "editor/outline/object_marks.h"
#include "editor/outline/outline_panel.h"
#include "editor/problems/problems_panel.h"
#include "editor/properties/editors/value_field.h"
#include "editor/properties/properties_panel.h"
#include "editor/radios/radios_panel.h"
#include "editor/running/panels/console_panel.h"
#include "editor/running/panels/controller_commands.h"
#include "editor/running/panels/controllers_panel.h"
#include "editor/running/panels/run_status.h"
#include "editor/running/panels/transport_bar.h"
#include "editor/sensors/sensors_panel.h"
#include "editor/shell/action_table.h"
#include "editor/shell/commands/arena_commands.h"
#include "editor/shell/commands/camera_commands.h"
#include "editor/shell/commands/design_commands.h"
#include "editor/shell/commands/edit_commands.h"
#include "editor/shell/commands/file_commands.h"
#include "editor/shell/commands/help_commands.h"
#include "editor/shell/commands/mesh_commands.h"
#include "editor/shell/commands/model_commands.h"
#include "editor/shell/commands/module_commands.h"
#include "editor/shell/commands/part_commands.h"
#include "editor/shell/commands/project_questions.h"
#include "editor/shell/commands/run_commands.h"
#include "editor/shell/dialogs/preferences_dialog.h"
#include "editor/shell/file_drop.h"
#include "editor/shell/help_panel.h"
#include "editor/shell/recent_files.h"
#include "editor/shell/saved_window_state.h"
#include "editor/shell/status_line.h"
#include "editor/shell/unsaved_files.h"
#include "editor/shell/welcome_page.h"
#include "editor/shell/window_menus.h"
#include "editor/shell/work_area.h"
#include "editor/text/text_panel.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/view/viewport_panel.h"
#include "editor/widgets/theme.h"
#include "editor/widgets/undo_keys.h"
#include "project/objects/object_location.h"

namespace trundle {
namespace {

/// Whether a command is disabled on the Welcome page. Undo, the run and the controllers enable theirs separately.
bool needsDocument(std::string_view id) {
    for (const char* other : {"file.new", "file.open", "file.quit", "edit.undo", "edit.redo", "edit.palette", "edit.preferences",
                              "view.theme", "view.look", "sim.", "controllers.", "help."})
        if (id.starts_with(other)) return id == "file.openSample" || id == "sim.record";
    return true;
}

/// Limits the window to the screen, so that neither the default size nor one restored from a larger screen hides the status bar.
void fitOnScreen(QWidget& window) {
    const Qt::WindowStates state = window.windowState();
    window.setWindowState(Qt::WindowNoState); // sets the size after unmaximizing
    const QRect room =
        window.screen()->availableGeometry().adjusted(4, 36, -4, -4); // margin for the frame, not known before showing
    QRect place = window.geometry();
    place.setSize(place.size().boundedTo(room.size()));
    const bool remembered = window.testAttribute(Qt::WA_Moved);
    if (remembered) {
        place.moveLeft(std::clamp(place.left(), room.left(), room.right() + 1 - place.width()));
        place.moveTop(std::clamp(place.top(), room.top(), room.bottom() + 1 - place.height()));
        window.setGeometry(place);
    } else {
        window.resize(place.size());
    }
    window.setWindowState(state);
}

} // namespace

MainWindow::MainWindow(Application& application, RenderService* render, const Locations& places, const OpenOptions& given)
    : m_actions(std::make_unique<Actions>(actionTable())), m_document(new Document(application, this)),
      m_selection(new Selection(this)), m_session(new RunSession(*m_document, application, this)), m_marks(new ObjectMarks(this)),
      m_edits(new ObjectEdits(*m_document, *m_selection, *m_marks, this)) {
    setObjectName(QStringLiteral("mainWindow"));
    resize(1440, 900);
    restoreGeometry(QSettings().value(QStringLiteral("windowGeometry")).toByteArray());
    fitOnScreen(*this);
    m_files = new FileCommands(*this, *m_document, *m_actions, QString::fromStdString(places.configs));
    m_layouts = new Layouts(*this);
    m_document->setOptions(given); // before the panels, which add what the user trusts
    makePanels(application, render, places);
    makeDocks();
    makeToolBars();
    connectDocument();
    connectPanels();
    connectActions();
    makeCommands(application, render, places);
    showDocument();
}

MainWindow::~MainWindow() {
    m_layouts->save();
    m_memory->save();
    delete m_memory; // before the views it refers to
    // Panels refer to document, selection and run until they are deleted.
    qDeleteAll(findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly));
    delete m_pages;
}

void MainWindow::makePanels(Application& application, RenderService* render, const Locations& places) {
    m_pages = new QStackedWidget;
    m_welcome = new WelcomePage(*m_actions, QString::fromStdString(places.configs));
    m_viewport = new ViewportPanel(*m_document, *m_selection, *m_session, render, *m_actions);
    m_text = new TextPanel(*m_document, *m_selection, *m_actions);
    m_text->setFolders({{places.configs}, {places.resources}, {places.modules}});
    m_work = new WorkArea(*m_viewport, *m_text, *m_actions);
    m_pages->addWidget(m_welcome);
    m_pages->addWidget(m_work);
    setCentralWidget(m_pages);

    m_sensors = new SensorsPanel(*m_document, *m_selection, *m_session, render);
    m_memory = new SavedWindowState(*m_document, *m_marks, *m_viewport, m_sensors->pins(), this);
    m_outline = new OutlinePanel(*m_document, *m_selection, *m_marks, *m_edits);
    m_outline->showValuesOf(*m_session);
    for (const char* id : {"model.edit", "parts.make", "parts.mirrorY", "parts.repeat", "view.pinValues"})
        m_outline->addToMenu(m_actions->at(id));
    m_library = new LibraryPanel(*m_document, *m_selection, application, render, places);
    m_properties = new PropertiesPanel(*m_document, *m_selection, m_session);
    m_properties->setMinimumWidth(300); // narrower, the rows would be cut off
    m_history = new HistoryPanel(*m_document);
    m_problems = new ProblemsPanel(*m_document, *m_selection);
    m_console = new ConsolePanel(*m_session);
    m_cameras = new CamerasPanel(*m_document, *m_session, render);
    m_radios = new RadiosPanel(*m_document, *m_selection, *m_session);
    m_controllers = new ControllersPanel(*m_document, *m_selection, *m_session, *m_actions);
    m_help = new HelpPanel;

    const auto commit = [this] {
        commitTyped(*m_properties);
        m_text->flush();
    };
    m_files->setFlush(commit);
    // Connected before the transport bar and the commands, so that it is called first.
    for (const char* id : {"sim.run", "sim.step", "sim.record", "model.drive", "controllers.build"})
        connect(&m_actions->at(id), &QAction::triggered, this, commit);
}

void MainWindow::makeDocks() {
    const std::initializer_list<std::tuple<QWidget*, const char*, QString>> docks{
        {m_outline, "scene", tr("Scene")},
        {m_library, "library", tr("Library")},
        {m_properties, "properties", tr("Properties")},
        {m_history, "history", tr("History")},
        {m_problems, "problems", tr("Problems")},
        {m_console, "console", tr("Console")},
        {m_controllers, "controllers", tr("Controllers")},
        {m_cameras, "cameras", tr("Cameras")},
        {m_radios, "radios", tr("Radio")},
        {m_sensors, "sensors", tr("Sensors")},
        {m_help, "guide", tr("Guide")}};
    for (const auto& [panel, name, title] : docks) {
        panel->setObjectName(QLatin1String(name));
        QDockWidget* dock = m_layouts->add(panel, title);
        if (panel != m_outline) dock->installEventFilter(this);
    }
}

void MainWindow::makeToolBars() {
    const auto bar = [this](const char* name, const QString& title) {
        QToolBar* made = addToolBar(title);
        made->setObjectName(QLatin1String(name));
        made->setIconSize({18, 18});
        made->setMovable(false);
        return made;
    };
    QToolBar* file = bar("toolbar.file", tr("File"));
    for (const char* id : {"file.open", "file.save"}) file->addAction(&m_actions->at(id));
    file->addSeparator();
    for (const char* id : {"edit.undo", "edit.redo"}) file->addAction(&m_actions->at(id));
    m_transport = new TransportBar(*m_session, *m_actions);
    bar("toolbar.run", tr("Simulation"))->addWidget(m_transport);
    QToolBar* tools = bar("toolbar.tools", tr("Tools"));
    for (const char* id : {"tool.select", "tool.move", "tool.rotate", "tool.scale", "tool.measure"})
        tools->addAction(&m_actions->at(id));
    tools->addSeparator();
    for (const char* id : {"tool.snap", "tool.drop", "view.frame"}) tools->addAction(&m_actions->at(id));
    tools->addSeparator();
    for (const char* id : {"view.text", "sim.drive"}) tools->addAction(&m_actions->at(id));
    m_status = new StatusLine(*statusBar(), *m_document, *m_session);
    connect(new RunStatus(*m_session, this), &RunStatus::changed, m_status, &StatusLine::setRunText);
}

void MainWindow::connectDocument() {
    connect(&m_document->opening(), &ProjectOpening::aboutToOpen, this, [this] { showPages(true); });
    const auto notOpened = [this] { showPages(m_document->isOpen()); };
    connect(&m_document->opening(), &ProjectOpening::cancelled, this, notOpened);
    connect(&m_document->opening(), &ProjectOpening::failed, this, notOpened);
    connect(m_document, &Document::opened, this, &MainWindow::showDocument);
    connect(m_document, &Document::opened, this, [this] { m_problemsMayCome = true; });
    connect(m_document, &Document::changed, this, &MainWindow::raiseProblemsOnce); // emitted after opened()
    connect(&m_document->texts(), &DocumentTexts::modifiedChanged, this, &MainWindow::showTitle);
    connect(&m_document->access(), &ProjectAccess::changed, this, &MainWindow::showTitle);
    connect(m_document, &Document::refused, m_status, &StatusLine::refuse);
    connect(m_document, &Document::selectionRequested, m_selection, [this](const auto& paths) {
        if (!paths.empty()) return m_selection->set(paths);
        std::vector<std::string> left = m_selection->paths();
        std::erase_if(left, [this](const std::string& path) { return !placeOf(*m_document->loaded(), path); });
        m_selection->set(left);
    });
    m_document->edits().restoreSelection(*m_selection);
    connect(m_document, &Document::notice, m_status, &StatusLine::refuse);
    connect(m_document, &Document::opened, m_console, &ConsolePanel::clear); // its messages refer to the previous project
    connect(&m_document->opening(), &ProjectOpening::failed, m_files, &FileCommands::reportNotOpened);
    m_questions = new ProjectQuestions(*this, *m_document, *m_files);
}

void MainWindow::connectPanels() {
    for (ObjectEdits* edits : {m_edits, &m_library->edits()})
        edits->setInsertionPoint([this] { return m_viewport->views().insertionPoint(); });
    connect(m_welcome, &WelcomePage::openRequested, m_files, &FileCommands::open);
    connect(m_welcome, &WelcomePage::tryRequested, m_files, &FileCommands::tryOut);
    connect(m_problems, &ProblemsPanel::countsChanged, m_status, &StatusLine::setProblems);
    m_status->setProblems(m_problems->errors(), m_problems->warnings());
    connect(m_status, &StatusLine::problemsRequested, this, [this] { m_layouts->raise(QStringLiteral("problems")); });
    connect(m_outline, &OutlinePanel::jumpTo, this, [this](const std::string& file, TextRange block) {
        m_work->showText(true);
        m_text->revealBlock(file, block);
    });
    const auto go = [this](const std::string& file, const SourceRange& range) { showPlace(file, range.range); };
    connect(m_properties, &PropertiesPanel::jumpTo, this, go);
    connect(m_problems, &ProblemsPanel::jumpTo, this, go);
    connect(m_problems, &ProblemsPanel::modelChecked, m_text, &TextPanel::setModelProblems);
    connect(m_controllers, &ControllersPanel::jumpTo, this, go);
    connect(m_controllers, &ControllersPanel::refused, m_status, &StatusLine::refuse);
    connect(m_controllers, &ControllersPanel::attentionRequested, this,
            [this] { m_layouts->raise(QStringLiteral("controllers")); });
    connect(m_marks, &ObjectMarks::hiddenChanged, this, [this] {
        m_viewport->world().setHidden({m_marks->hidden().begin(), m_marks->hidden().end()});
    });
    connect(m_marks, &ObjectMarks::lockedChanged, this, [this] {
        m_viewport->world().setLocked({m_marks->locked().begin(), m_marks->locked().end()});
    });
    connect(m_text, &TextPanel::messageRequested, m_status, &StatusLine::refuse);
    connect(m_radios, &RadiosPanel::messageRequested, m_status, &StatusLine::refuse);
    connect(m_cameras, &CamerasPanel::messageRequested, m_status, &StatusLine::refuse);
    connect(m_cameras, &CamerasPanel::lookThroughRequested, this, [this](const std::string& camera) {
        m_work->showViewport(true);
        m_viewport->views().current().camera().lookThrough(camera);
    });
    connect(m_outline, &OutlinePanel::lookThroughRequested, this, [this](const std::string& path) {
        m_work->showViewport(true);
        m_viewport->views().lookThrough(path);
    });
    m_text->installEventFilter(this);
    qApp->installEventFilter(new UndoKeys(this));
    new FileDrop(*this, [this](const QString& path) { m_files->open(path); });
}

void MainWindow::checkRobotsWith(const std::string& program) { m_problems->checkRobotsWith(program); }

void MainWindow::makeCommands(Application& application, RenderService* render, const Locations& places) {
    auto* insert = new InsertMenu(*m_document, *m_selection, *m_edits, this);
    new WindowMenus(*this, *m_actions, {*m_files, *m_controllers, *m_layouts, *insert});
    new EditCommands(*this, *m_actions, {*m_document, *m_selection, *m_edits, *m_outline, *m_text, *m_work, *m_layouts},
                     places.configs);
    new PartCommands(*this, *m_actions, *m_document, *m_selection);
    new RunCommands(*this, *m_actions, {*m_session, *m_selection, *m_viewport, *m_problems, *m_layouts, *m_status});
    new ModelCommands(*this, *m_actions,
                      {*m_document, *m_selection, *m_session, *m_edits, *m_viewport, *m_work, *m_layouts, *m_status});
    m_modules = new ModuleCommands(*this, *m_actions,
                                   {application, *m_document, *m_selection, *m_session, *m_files, *m_controllers, *m_problems,
                                    *m_text, *m_work, *m_layouts, *m_status});
    new ArenaCommands(*this, *m_actions, *m_document, m_viewport->world(), places);
    new MeshCommands(*this, *m_actions, *m_document, *m_selection, m_viewport->world(), places);
    new DesignCommands(*this, *m_actions, *m_document, *m_files, *m_controllers, places);
    new CameraCommands(*this, *m_actions, {application, *m_document, *m_session, *m_viewport, *m_status, render});
    new HelpCommands(*this, *m_actions, {*m_document, *m_selection, *m_text, *m_help, *m_layouts});
}

void MainWindow::connectActions() {
    const auto on = [this](const char* id, auto what) { connect(&m_actions->at(id), &QAction::triggered, this, what); };
    on("file.quit", [this] { close(); });
    on("edit.preferences", [this] {
        PreferencesDialog dialog(*m_actions, this);
        connect(&dialog, &PreferencesDialog::changed, this, &MainWindow::applyPreferences);
        dialog.exec();
        m_controllers->commands().applyTrust();
    });
    on("view.theme", [this](bool dark) { setDarkTheme(dark); });
    on("view.layoutEdit", [this] { setLayout(Layout::Edit); });
    on("view.layoutRun", [this] { setLayout(Layout::Run); });
    on("view.layoutReset", [this] {
        m_layouts->resetCurrent();
        m_work->showText(m_layouts->current() == Layout::Edit);
        m_work->showViewport(true);
    });
    on("problems.next", [this] { m_problems->goTo(1); });
    on("problems.previous", [this] { m_problems->goTo(-1); });
    on("problems.fix", [this] { m_problems->fixCurrent(); });
    const Preferences preferences = loadPreferences();
    applyPreferences(preferences, preferences);
}

/// Shows the main page with docks and tool bars, or the Welcome page.
void MainWindow::showPages(bool work) {
    m_pages->setCurrentWidget(work ? static_cast<QWidget*>(m_work) : m_welcome);
    m_layouts->setShown(work);
    for (QToolBar* bar : findChildren<QToolBar*>(Qt::FindDirectChildrenOnly)) bar->setVisible(work);
    statusBar()->setVisible(work);
}

void MainWindow::showDocument() {
    const bool open = m_document->isOpen();
    showPages(open);
    if (open && m_savesSettings && !m_document->isNew()) addRecentFile(QString::fromStdString(m_document->path()));
    if (!open) m_welcome->refresh();
    for (const ActionRow& row : m_actions->table())
        if (needsDocument(row.id)) m_actions->at(row.id).setEnabled(open);
    m_selection->clear();
    showTitle();
}

void MainWindow::showTitle() {
    if (!m_document->isOpen()) return setWindowTitle(tr("Trundle"));
    setWindowTitle(trundle::windowTitle(*m_document));
    setWindowModified(m_document->texts().isModified() || m_document->isNew());
}

} // namespace trundle
