#pragma once
// The main window: creates and connects the panels. Only this class uses all of them.

#include <memory>

#include <QLabel>
#include <QMainWindow>
#include <QStackedWidget>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/running/session.h"
#include "editor/shell/layouts.h"
#include "editor/widgets/actions.h"
#include "editor/widgets/preferences.h"

namespace trundle {

class CamerasPanel;
class ConsolePanel;
class ControllersPanel;
class FileCommands;
class HelpPanel;
class HistoryPanel;
class LibraryPanel;
class ModuleCommands;
class ObjectEdits;
class OutlinePanel;
class ProblemsPanel;
class ProjectQuestions;
class PropertiesPanel;
class RadiosPanel;
class SensorsPanel;
class RenderService;
class ObjectMarks;
class StatusLine;
class TextPanel;
class TransportBar;
class ViewportPanel;
class WelcomePage;
class SavedWindowState;
class WorkArea;

class MainWindow final : public QMainWindow {
    Q_OBJECT
public:
    /// `render` is null without OpenGL; the viewports then show a message. Both must outlive the window. `given` holds search folders
    /// and trusted modules from the command line, for every project of this window.
    MainWindow(Application& application, RenderService* render, const Locations& places, const OpenOptions& given = {});
    ~MainWindow() override;

    [[nodiscard]] Document& document() { return *m_document; }
    [[nodiscard]] Selection& selection() { return *m_selection; }
    [[nodiscard]] RunSession& session() { return *m_session; }
    [[nodiscard]] Actions& actions() { return *m_actions; }
    [[nodiscard]] ViewportPanel& viewport() { return *m_viewport; }
    [[nodiscard]] TextPanel& text() { return *m_text; }
    [[nodiscard]] WorkArea& work() { return *m_work; }
    [[nodiscard]] ProjectQuestions& questions() { return *m_questions; }
    [[nodiscard]] ModuleCommands& modules() { return *m_modules; }

    /// Asks about unsaved changes, then opens. False if the user cancelled.
    bool open(const QString& path);
    /// For running the viewport is in the centre; for editing the text is shown as before.
    void setLayout(Layout layout);
    /// Everything visible is up to date. For tests and screenshots.
    [[nodiscard]] bool isSettled() const;
    /// Restores and saves hidden and locked objects, cameras, overlays and snap steps per experiment.
    void rememberViews();
    /// Recent files and the size and docks of this window are not saved.
    void disableSettings();
    /// See ProblemsPanel.
    void checkRobotsWith(const std::string& program);
    /// Saves the settings and closes the project. The window must not be used afterwards.
    void putAway();

protected:
    void closeEvent(QCloseEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void makePanels(Application& application, RenderService* render, const Locations& places);
    void makeDocks();
    void makeToolBars();
    void makeCommands(Application& application, RenderService* render, const Locations& places);
    void connectDocument();
    void connectPanels();
    void connectActions();
    void showPages(bool work);
    void showDocument();
    void showTitle();
    void raiseProblemsOnce();
    void showPlace(const std::string& file, TextRange range);
    void setDarkTheme(bool dark);
    void applyPreferences(const Preferences& before, const Preferences& now);

    std::unique_ptr<Actions> m_actions;
    Document* m_document;
    Selection* m_selection;
    RunSession* m_session;
    ObjectMarks* m_marks;
    ObjectEdits* m_edits;
    FileCommands* m_files = nullptr;
    ProjectQuestions* m_questions = nullptr;
    ModuleCommands* m_modules = nullptr;
    Layouts* m_layouts = nullptr;

    QStackedWidget* m_pages = nullptr;
    WorkArea* m_work = nullptr;
    WelcomePage* m_welcome = nullptr;
    ViewportPanel* m_viewport = nullptr;
    TextPanel* m_text = nullptr;
    OutlinePanel* m_outline = nullptr;
    LibraryPanel* m_library = nullptr;
    PropertiesPanel* m_properties = nullptr;
    HistoryPanel* m_history = nullptr;
    ProblemsPanel* m_problems = nullptr;
    ConsolePanel* m_console = nullptr;
    CamerasPanel* m_cameras = nullptr;
    RadiosPanel* m_radios = nullptr;
    SensorsPanel* m_sensors = nullptr;
    ControllersPanel* m_controllers = nullptr;
    HelpPanel* m_help = nullptr;
    TransportBar* m_transport = nullptr;
    StatusLine* m_status = nullptr;
    SavedWindowState* m_memory = nullptr;
    bool m_savesSettings = true, m_problemsMayCome = false;
};

} // namespace trundle
