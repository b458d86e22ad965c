#pragma once
// The main window: creates and connects the panels. Only this class uses all of them.

#include <map>
#include <memory>

#include <QLabel>
#include <QMainWindow>
#include <QSplitter>
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
class ObjectEdits;
class OutlinePanel;
class ProblemsPanel;
class PropertiesPanel;
class RadiosPanel;
class RenderService;
class ObjectMarks;
class StatusLine;
class TextPanel;
class TransportBar;
class ViewportPanel;
class WelcomePage;
class SavedWindowState;

struct Kind;

class MainWindow final : public QMainWindow {
    Q_OBJECT
public:
    /// `render` is null without OpenGL; the viewports then show a message. Both must outlive the window.
    MainWindow(Application& application, RenderService* render, const Locations& places);
    ~MainWindow() override;

    [[nodiscard]] Document& document() { return *m_document; }
    [[nodiscard]] Selection& selection() { return *m_selection; }
    [[nodiscard]] RunSession& session() { return *m_session; }
    [[nodiscard]] Actions& actions() { return *m_actions; }
    [[nodiscard]] ViewportPanel& viewport() { return *m_viewport; }
    [[nodiscard]] TextPanel& text() { return *m_text; }

    /// Asks about unsaved changes, then opens. False if the user cancelled.
    bool open(const QString& path);
    /// For running the viewport is in the centre; for editing the text is shown as before.
    void setLayout(Layout layout);
    /// Shows or hides the text next to the viewport.
    void showText(bool shown);
    void showHelp();
    [[nodiscard]] const Kind* kindForHelp();
    /// "perspective", "top", "front", "side", "follow", "chase", or "text": the text alone. "" does nothing.
    void useView(const QString& name);
    /// Everything visible is up to date. For tests and screenshots.
    [[nodiscard]] bool isSettled() const;
    /// Restores and saves hidden and locked objects, cameras, overlays and snap steps per experiment.
    void rememberViews();
    /// Shows and removes the reports of windows that crashed, in `folder`; see keepCrashReport().
    void showCrashReports(const QString& folder);
    /// Recent files and the size and docks of this window are not saved.
    void disableSettings();
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
    void connectPanels();
    void connectActions();
    void showPages(bool work);
    void showDocument();
    void showTitle();
    void connectLogs();
    void raiseProblemsOnce();
    void showPlace(const std::string& file, TextRange range);
    void showViewport(bool shown);
    void doEdit(const char* id);
    [[nodiscard]] QList<QAction*> insertActions();
    void showUndo();
    void connectCameras(Application& application, RenderService* render);
    [[nodiscard]] QString pictureFile(const QString& ending) const;
    void askAboutDiskChange(const QString& file);
    void offerRecovery();
    void reportJournals();
    void showReadOnly(const QString& holder);
    void setDarkTheme(bool dark);
    void applyPreferences(const Preferences& before, const Preferences& now);
    void openPalette();
    void showAbout();

    std::unique_ptr<Actions> m_actions;
    Document* m_document;
    Selection* m_selection;
    RunSession* m_session;
    ObjectMarks* m_marks;
    ObjectEdits* m_edits;
    FileCommands* m_files = nullptr;
    Layouts* m_layouts = nullptr;

    QStackedWidget* m_pages = nullptr;
    QSplitter* m_work = nullptr;
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
    ControllersPanel* m_controllers = nullptr;
    HelpPanel* m_help = nullptr;
    TransportBar* m_transport = nullptr;
    StatusLine* m_status = nullptr;
    SavedWindowState* m_memory = nullptr;
    bool m_savesSettings = true, m_textForEditing = true, m_problemsMayCome = false;
    QString m_reportedJournals; ///< the last message of reportJournals()
    std::map<QString, QMenu*> m_menus;
};

} // namespace trundle
