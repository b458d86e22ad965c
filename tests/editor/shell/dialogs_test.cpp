// Every dialog and question of the program, opened by its real code: Enter never triggers a destructive button, all text is
// visible at the font sizes that Preferences offers, no Alt-letter is there twice, and each fits a screen of 800x500. A dialog in the
// sources that the table below does not list is a failure. If TRUNDLE_PICTURES=FOLDER is in the environment, an image of each is saved
// there.

#include <QComboBox>
#include <QDialog>
#include <QDirIterator>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QSettings>
#include <QTemporaryDir>
#include <QToolButton>
#include <QTreeWidget>

#include <map>
#include <set>

#include "editor/cameras/movie_dialog.h"
#include "editor/document/structure_edits.h"
#include "editor/running/panels/controller_dialogs.h"
#include "editor/shell/commands/project_questions.h"
#include "editor/shell/cut_off_texts.h"
#include "editor/shell/dialogs/share_dialog.h"
#include "editor/shell/shared_mnemonics.h"
#include "editor/shell/window_fixture.h"
#include "editor/widgets/widget_text.h"
#include "eventually.h"
#include "project/journal/journal.h"
#include "project/journal/project_lock.h"
#include "project/loading/search.h"

using namespace trundle;

namespace {

const QByteArray kMain =
    "#import rover.sim\n#import arenas/open_floor.sim\nTick = 0.01  Duration = 60\nStatic floor { Config=OpenFloor }\n"
    "Robot robot0 { Config=Rover }\nRobot robot1 { Config=Rover Pos=1,0,0 }\nRobot robot2 { Config=Rover Pos=2,0,0 }\nPoseLog "
    "path { Robot=robot0 Interval=0.1 }\n";
const QByteArray kRover = "RobotConfig Rover { Body b { Box hull { Pos=0,0,0.05 Size=0.1,0.1,0.1 Mass=1 } } }\n";

struct Question {
    const char* source; ///< relative to editor/
    const char* name;   ///< its object name, otherwise its title
    const char* pressedByEnter;
};
// One line for each dialog that a source file creates.
constexpr Question kQuestions[] = {
    {"cameras/movie_dialog.h", "movieDialog", "Record"},
    {"cameras/picture_dialog.h", "pictureDialog", "Save"},
    {"outline/object_edits.cpp", "deleteQuestion", "Delete All"},
    {"running/panels/controller_dialogs.cpp", "trustQuestion", "Cancel"},
    {"running/panels/controller_dialogs.cpp", "chooseController", "Assign"},
    {"shell/commands/command_palette.h", "commandPalette", ""},
    {"shell/commands/file_commands.cpp", "fileMessage", "OK"},
    {"shell/commands/file_commands.cpp", "unsavedQuestion", "Save"},
    {"shell/dialogs/group_dialog.cpp", "groupDialog", "Group"},
    {"shell/dialogs/new_module_dialog.h", "newModule", "Create"},
    {"shell/dialogs/new_arena_dialog.h", "newArena", "Create"},
    {"shell/dialogs/new_robot_dialog.h", "newRobot", "Create"},
    {"shell/dialogs/remote_dialog.h", "remoteDialog", "Close"},
    {"shell/dialogs/room_dialog.h", "roomDialog", "Insert"},
    {"shell/dialogs/maze_dialog.h", "mazeDialog", "Insert"},
    {"shell/dialogs/obstacles_dialog.h", "obstaclesDialog", "Insert"},
    {"shell/dialogs/mesh_dialog.h", "meshDialog", "Insert"},
    {"shell/dialogs/heights_dialog.h", "heightsDialog", "Insert"},
    {"shell/dialogs/repeat_dialog.h", "repeatDialog", "Repeat"},
    {"shell/dialogs/sensor_ring_dialog.h", "sensorRingDialog", "Insert"},
    {"shell/main_window_commands.cpp", "movieQuestion", "Continue"},
    {"shell/commands/project_questions.cpp", "journalsNotRead", "OK"},
    {"shell/commands/project_questions.cpp", "crashReport", "OK"},
    {"shell/commands/project_questions.cpp", "lockQuestion", "Open Read-Only"},
    {"shell/commands/project_questions.cpp", "diskQuestion", "Keep My Version"},
    {"shell/commands/help_commands.cpp", "about", "OK"},
    {"shell/dialogs/preferences_dialog.h", "preferences", ""},
    {"shell/dialogs/preferences_dialog.cpp", "Keys in use", "No"},
    {"shell/dialogs/recovery_dialog.h", "recovery", "Restore"},
    {"shell/dialogs/recovery_dialog.cpp", "Not restored", "OK"},
    {"shell/dialogs/recovery_dialog.cpp", "discardQuestion", "Cancel"},
    {"shell/dialogs/share_dialog.cpp", "shareQuestion", "Make a copy for this experiment"},
    {"viewport/tools/array_dialog.h", "arrayDialog", "Copy"},
};

QString nameOf(const QDialog& dialog) { return dialog.objectName().isEmpty() ? dialog.windowTitle() : dialog.objectName(); }
QString bare(QString text) { return text.remove(u'&'); }

} // namespace

class DialogsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        m_fixture.start();
        fillOpeners();
    }
    void init() { QSettings().clear(); }
    void cleanup() {
        if (!m_window) return;
        while (m_window->document().edits().history().canUndo()) m_window->document().edits().undo();
        if (std::exchange(m_ownFolder, false)) m_window.reset();
        m_lock.reset();
    }
    void cleanupTestCase() { m_window.reset(); }

    void everyDialogInTheSourcesIsOpenedHere() {
        std::map<QString, int> listed, found;
        for (const Question& question : kQuestions) {
            ++listed[QLatin1String(question.source)];
            QVERIFY2(m_openers.contains(QLatin1String(question.name)), question.name);
        }
        const QString root = QStringLiteral(TRUNDLE_SOURCE_DIR "/editor/");
        const QRegularExpression made(QStringLiteral(
            R"(new Q(Dialog|MessageBox|InputDialog|ErrorMessage)\(|\bQ(MessageBox|Dialog|InputDialog|ErrorMessage) \w+[({;]|Q(MessageBox|InputDialog)::[a-z]\w*\(|: public Q(Dialog|MessageBox)\b)"));
        for (QDirIterator files(root, {QStringLiteral("*.cpp"), QStringLiteral("*.h")}, QDir::Files,
                                QDirIterator::Subdirectories);
             files.hasNext();) {
            QFile file(files.next());
            QVERIFY(file.open(QIODevice::ReadOnly));
            for (auto hits = made.globalMatch(QString::fromUtf8(file.readAll())); hits.hasNext(); hits.next())
                ++found[QDir(root).relativeFilePath(file.fileName())];
        }
        for (const auto& [source, count] : found)
            QVERIFY2(
                listed[source] == count,
                qPrintable(QStringLiteral("%1 makes %2 dialogs, %3 are opened here").arg(source).arg(count).arg(listed[source])));
        QCOMPARE(found.size(), listed.size());
    }

    void enterLosesNothingAndAllIsSeen_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("pressed");
        QTest::addColumn<bool>("dark");
        QTest::addColumn<int>("font");
        for (const auto& [dark, font] : {std::pair(false, 13), std::pair(false, 17), std::pair(true, 17), std::pair(true, 13)})
            for (const Question& q : kQuestions)
                QTest::addRow("%s %s %d px", q.name, dark ? "dark" : "light", font) << q.name << q.pressedByEnter << dark << font;
    }
    void enterLosesNothingAndAllIsSeen() {
        QFETCH(QString, name);
        QFETCH(QString, pressed);
        QFETCH(bool, dark);
        QFETCH(int, font);
        useTheme(dark ? ThemeKind::Dark : ThemeKind::Light, font);
        QString byEnter;
        QStringList faults;
        openAndClose(name, [&](QDialog& dialog) {
            for (auto* button : dialog.findChildren<QPushButton*>()) {
                if (!button->isDefault()) continue;
                byEnter = bare(button->text());
                if (auto* box = qobject_cast<QMessageBox*>(&dialog);
                    box && box->buttonRole(button) == QMessageBox::DestructiveRole)
                    faults << QStringLiteral("Enter presses what loses something");
            }
            faults << cutOff(dialog) << sharedMnemonics(dialog);
            if (!dark && font == 13) faults << described(name, dialog);
            if (const auto* open = dialog.findChild<QPushButton*>(QStringLiteral("movieOpen")); open && open->isVisible())
                faults << QStringLiteral("a movie is offered that there is not");
            const QSize least = dialog.minimumSizeHint().expandedTo(dialog.minimumSize());
            if (least.width() > 800 || least.height() > 500)
                faults << QStringLiteral("needs %1x%2").arg(least.width()).arg(least.height());
            if (const QString folder = qEnvironmentVariable("TRUNDLE_PICTURES"); !folder.isEmpty())
                dialog.grab().save(
                    QStringLiteral("%1/%2-%3-%4.png")
                        .arg(folder, QString(name).replace(u' ', u'_'), dark ? QStringLiteral("dark") : QStringLiteral("light"))
                        .arg(font));
        });
        QCOMPARE(byEnter, pressed);
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join(QStringLiteral("; "))));
    }

    void theShareQuestionFitsWithLongNames() {
        for (const int font : {13, kLargestInterfaceFont}) {
            useTheme(ThemeKind::Light, font);
            QWidget window;
            const QString name = QStringLiteral("MediumArenaWithFourHighWallsAndThreeRampsForTheSecondExperiment");
            askAboutSharedConfig(&window, {name, QStringLiteral("a.sim"), QStringLiteral("b.sim"), {}, {name}, 12},
                                 [](ShareChoice) {});
            auto* question = window.findChild<QDialog*>(QStringLiteral("shareQuestion"));
            QVERIFY(question);
            const QSize least = question->sizeHint();
            QVERIFY2(least.width() <= 800, qPrintable(QString::number(least.width())));
            QVERIFY2(cutOff(*question).isEmpty(), qPrintable(cutOff(*question).join(QStringLiteral("; "))));
        }
    }

    /// The views change size with each font, so images of many sizes are drawn.
    void oneWindowFollowsManyThemes() {
        m_window.reset();
        openWindow();
        const MainWindow* window = m_window.get();
        m_window->resize(1600, 1000);
        int changes = 0;
        const auto change = [&] {
            ++changes;
            useTheme(changes % 2 ? ThemeKind::Dark : ThemeKind::Light, kSmallestFont + changes % 7);
            QApplication::processEvents();
        };
        const std::set<QByteArray> ofOtherWindows{"journalsNotRead", "crashReport",     "lockQuestion", "diskQuestion",
                                                  "recovery",        "discardQuestion", "Not restored"};
        for (const Question& question : kQuestions) {
            if (ofOtherWindows.contains(question.name)) continue;
            openAndClose(QLatin1String(question.name), [](QDialog&) {});
            while (m_window->document().edits().history().canUndo()) m_window->document().edits().undo();
            change();
        }
        change();
        QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        const auto widgets = QApplication::allWidgets().size();
        const auto styles = qApp->findChildren<QStyle*>().size();
        while (changes < 40) change();
        QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QCOMPARE(QApplication::allWidgets().size(), widgets);
        QCOMPARE(qApp->findChildren<QStyle*>().size(), styles);
        QCOMPARE(m_window.get(), window);
    }

    void theWindowHasRoomForItsWordsAtEveryFont() {
        for (const int font : {17, kLargestInterfaceFont, kSmallestFont, 13}) {
            useTheme(ThemeKind::Light, font);
            openWindow();
            m_window->resize(1600, 1000);
            QTRY_VERIFY2_WITH_TIMEOUT(
                cutOff(*m_window).isEmpty(),
                qPrintable(QStringLiteral("%1 px: %2").arg(font).arg(cutOff(*m_window).join(QStringLiteral("; ")))), kTimeoutMs);
            const auto* corner = m_window->findChild<QToolButton*>(QStringLiteral("viewKind"));
            QVERIFY(corner && corner->width() >= corner->fontMetrics().horizontalAdvance(corner->text()) + 28); // and its arrow
            QVERIFY(corner->parentWidget()->rect().contains(corner->geometry()));
        }
    }

private:
    /// Why the dialog does not show and offer what tests/data/window says; empty if it does.
    QStringList described(const QString& name, const QDialog& dialog) const {
        const QString folder = m_folder ? QDir(m_folder->path()).canonicalPath() : QString();
        const QString difference =
            differenceFromKept(QStringLiteral("dialog-") + QString(name).replace(u' ', u'_'), describedWidget(dialog), folder);
        return difference.isEmpty() ? QStringList() : QStringList{difference};
    }
    void useTheme(ThemeKind kind, int font) {
        if (currentTheme() == kind && m_font == font) return;
        m_font = font;
        applyTheme(*qApp, kind, {font, font});
    }
    void openAndClose(const QString& name, const std::function<void(QDialog&)>& look) {
        bool seen = false;
        QTimer timer;
        connect(&timer, &QTimer::timeout, this, [&] {
            for (QWidget* widget : QApplication::topLevelWidgets()) {
                auto* dialog = qobject_cast<QDialog*>(widget);
                if (!dialog || !dialog->isVisible() || nameOf(*dialog) != name || seen) continue;
                QApplication::processEvents(QEventLoop::ExcludeUserInputEvents); // lets it handle the events after being shown
                seen = true;
                look(*dialog);
                dialog->close();
                if (dialog->isVisible()) dialog->reject();
                return;
            }
        });
        timer.start(0);
        m_openers.at(name)();
        EVENTUALLY(seen);
    }
    [[nodiscard]] QString path(const char* name) const {
        return QDir(m_folder->path()).canonicalPath() + u'/' + QLatin1String(name);
    }
    void write(const char* name, const QByteArray& bytes) const {
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(bytes);
    }
    /// Opens one window for all dialogs, except those that need another folder.
    void openWindow() {
        if (m_window) return;
        if (!m_ownFolder) makeFolder();
        m_window = m_fixture.window();
        m_window->show();
        QVERIFY(m_window->open(path("main.sim")));
        EVENTUALLY(m_window->document().isOpen());
    }
    void makeFolder() {
        m_folder = std::make_unique<QTemporaryDir>();
        write("main.sim", kMain);
        write("rover.sim", kRover);
    }
    /// Makes a folder for a window that needs files in it.
    void makeOwnFolder() {
        m_window.reset();
        makeFolder();
        m_ownFolder = true;
    }
    void trigger(const char* action, const std::vector<std::string>& selected = {}) {
        openWindow();
        if (!selected.empty()) m_window->selection().set(selected);
        m_window->actions().at(action).trigger();
    }
    void edit() { QVERIFY(m_window->document().structure().setValues(QStringLiteral("Move"), {{"robot0.Pos", "1,0,0"}}).ok()); }
    /// Leaves a journal with edits of a file, as a killed window does.
    void leaveJournal(const char* name) const {
        const std::string file = path(name).toStdString(), before = kMain.toStdString();
        const auto shared = [](const std::string& text) { return std::make_shared<const std::string>(text); };
        QVERIFY(Journal(projectFolderOf(file), {file, {}}).note(file, shared(before), shared(before + "Seed = 3\n")).ok());
    }
    void press(const char* dialog, const char* button) {
        EVENTUALLY(m_window->findChild<QDialog*>(QLatin1String(dialog)));
        m_window->findChild<QDialog*>(QLatin1String(dialog))->findChild<QPushButton*>(QLatin1String(button))->click();
    }
    void recordAndClose() {
        trigger("sim.record");
        auto* dialog = m_window->findChild<MovieDialog*>();
        QVERIFY(dialog);
        dialog->findChild<QLineEdit*>(QStringLiteral("movieFile"))->setText(path("a.mp4"));
        dialog->findChild<QPushButton*>(QStringLiteral("movieRecord"))->click();
        QVERIFY(dialog->isRecording());
        m_window->close();
        dialog->close(); // cancels the recording
        EVENTUALLY(!dialog->isRecording());
        delete dialog;
    }
    void askForUsedKeys() {
        openWindow();
        QTimer::singleShot(0, m_window.get(), [this] { // after Preferences, whose exec() blocks, is open
            auto* dialog = m_window->findChild<QDialog*>(QStringLiteral("preferences"));
            QVERIFY(dialog);
            dialog->findChild<QKeySequenceEdit*>(QStringLiteral("keys"))
                ->setKeySequence(m_window->actions().at("file.save").shortcut());
            dialog->findChild<QPushButton*>(QStringLiteral("setKeys"))->click();
            dialog->close();
        });
        trigger("edit.preferences");
    }
    void failToRestore() {
        makeOwnFolder();
        write("other.sim", kMain);
        leaveJournal("other.sim");
        openWindow();
        EVENTUALLY(m_window->findChild<QDialog*>(QStringLiteral("recovery")));
        QVERIFY(QFile::remove(path("other.sim")) && QDir().mkdir(path("other.sim")));
        press("recovery", "restoreEdits");
    }

    void fillOpeners() {
        m_openers[QStringLiteral("movieDialog")] = [this] { trigger("sim.record"); };
        m_openers[QStringLiteral("pictureDialog")] = [this] { trigger("view.savePicture"); };
        m_openers[QStringLiteral("deleteQuestion")] = [this] { trigger("edit.delete", {"robot0"}); };
        m_openers[QStringLiteral("commandPalette")] = [this] { trigger("edit.palette"); };
        m_openers[QStringLiteral("groupDialog")] = [this] { trigger("edit.group", {"robot1", "robot2"}); };
        m_openers[QStringLiteral("sensorRingDialog")] = [this] { trigger("sensors.ring", {"robot0.b"}); };
        m_openers[QStringLiteral("repeatDialog")] = [this] { trigger("parts.repeat", {"robot0.b"}); };
        m_openers[QStringLiteral("newModule")] = [this] { trigger("controllers.new", {"robot0"}); };
        m_openers[QStringLiteral("newArena")] = [this] { trigger("file.newFromPlan"); };
        m_openers[QStringLiteral("newRobot")] = [this] { trigger("file.newFromDimensions"); };
        m_openers[QStringLiteral("remoteDialog")] = [this] { trigger("sim.remote"); };
        m_openers[QStringLiteral("roomDialog")] = [this] { trigger("arena.room"); };
        m_openers[QStringLiteral("mazeDialog")] = [this] { trigger("arena.maze"); };
        m_openers[QStringLiteral("obstaclesDialog")] = [this] { trigger("arena.obstacles"); };
        m_openers[QStringLiteral("heightsDialog")] = [this] { trigger("arena.heights"); };
        m_openers[QStringLiteral("meshDialog")] = [this] { trigger("mesh.import"); };
        m_openers[QStringLiteral("about")] = [this] { trigger("help.about"); };
        m_openers[QStringLiteral("preferences")] = [this] { trigger("edit.preferences"); };
        m_openers[QStringLiteral("arrayDialog")] = [this] { trigger("tool.array", {"robot0"}); };
        m_openers[QStringLiteral("Keys in use")] = [this] { askForUsedKeys(); };
        m_openers[QStringLiteral("movieQuestion")] = [this] { recordAndClose(); };
        m_openers[QStringLiteral("Not restored")] = [this] { failToRestore(); };
        m_openers[QStringLiteral("trustQuestion")] = [] {
            (void)askForTrust(QStringLiteral("/opt/robots/modules/libwander.so"), QStringLiteral("/opt/robots/modules"), nullptr);
        };
        m_openers[QStringLiteral("chooseController")] = [this] {
            openWindow();
            (void)chooseController(controllerChoices(*m_window->document().loaded(), m_fixture.application->moduleKinds({}),
                                                     findLocations().modules),
                                   {"robot0"}, m_window.get());
        };
        m_openers[QStringLiteral("shareQuestion")] = [this] {
            openWindow();
            (void)m_window->document().structure().apply(
                QStringLiteral("Insert"), {"robot0"},
                [](const LoadedProject& loaded, const StructureEdits::PathMapping& renamed) {
                    return planInsert(loaded, renamed("robot0"), "Body arm { Sphere ball { Radius=0.1 Mass=1 } }");
                });
        };
        m_openers[QStringLiteral("fileMessage")] = [this] {
            openWindow();
            (void)m_window->open(path("none.sim"));
        };
        m_openers[QStringLiteral("unsavedQuestion")] = [this] {
            openWindow();
            edit();
            m_window->close();
        };
        m_openers[QStringLiteral("journalsNotRead")] = [this] {
            makeOwnFolder();
            QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral(".trundle/journal")));
            write(".trundle/journal/1.journal", "from yesterday");
            openWindow();
        };
        m_openers[QStringLiteral("crashReport")] = [this] {
            makeOwnFolder();
            QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("crashes")));
            write("crashes/7.txt", "the controller Zoo of rover (/opt/robots/modules/libzoo.so) crashed in update at t = 0.49 s: "
                                   "Segmentation fault\n");
            openWindow();
            m_window->questions().showCrashReports(path("crashes"));
        };
        m_openers[QStringLiteral("lockQuestion")] = [this] {
            makeOwnFolder();
            m_lock =
                std::make_unique<ProjectLock>(projectFolderOf(path("main.sim").toStdString()), path("main.sim").toStdString());
            QVERIFY(m_lock->taken());
            openWindow();
        };
        m_openers[QStringLiteral("diskQuestion")] = [this] {
            makeOwnFolder();
            openWindow();
            edit();
            write("main.sim", QByteArray(kMain).replace("robot0 { Config=Rover", "robot0 { Config=Rover Pos=7,0,0"));
            m_window->document().disk().check();
        };
        m_openers[QStringLiteral("recovery")] = [this] {
            makeOwnFolder();
            leaveJournal("main.sim");
            openWindow();
        };
        m_openers[QStringLiteral("discardQuestion")] = [this] {
            makeOwnFolder();
            leaveJournal("main.sim");
            openWindow();
            press("recovery", "discardEdits");
        };
    }

    WindowFixture m_fixture;
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;
    std::unique_ptr<ProjectLock> m_lock;
    bool m_ownFolder = false;
    int m_font = 0;
    std::map<QString, std::function<void()>> m_openers; // by object name of the dialog
};

QTEST_MAIN(DialogsTest)
#include "dialogs_test.moc"
