// Controllers of the user's own, from the menu to the running robot: new, edited, built, used. With CMake and the compiler of the machine.

#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QRadioButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QToolButton>
#include <QTreeView>
#include <QtTest>

#include "editor/problems/problems_model.h"
#include "editor/problems/problems_panel.h"
#include "editor/running/panels/controller_commands.h"
#include "editor/running/panels/controllers_panel.h"
#include "editor/running/panels/trust.h"
#include "editor/shell/commands/module_commands.h"
#include "editor/shell/window_fixture.h"
#include "editor/text/code/code_edit.h"
#include "editor/text/pages/file_page.h"
#include "editor/text/text_panel.h"
#include "eventually.h"

using namespace trundle;

namespace {

const QByteArray kMain = "#import robots/simple_robot.sim\n#import arenas/open_floor.sim\nTick = 0.01\n"
                         "Static floor { Config=OpenFloor }\nRobot rover { Config=SimpleRobot }\n";
double valueOf(const RunResults& results, const char* signal) {
    const auto entry = results.layout ? results.layout->find(signal) : std::nullopt;
    return entry && results.snapshot ? results.snapshot->block->slots()[entry->offset] : 0;
}

constexpr int kBuildMs = 120'000; // of a slow machine

} // namespace

class ModulesTest final : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        applyTheme(*qApp, ThemeKind::Light);
        m_application = makeApplication(findLocations(), Isolation::Module); // as the program does
    }
    void init() {
        QSettings().clear();
        m_folder = std::make_unique<QTemporaryDir>();
        write("main.sim", kMain);
        openWindow();
        m_result.reset();
        connect(&m_window->modules().builder(), &ModuleBuilder::ended, this, [this](const BuildResult& result) { m_result = result; });
    }
    void cleanup() { m_window.reset(); }

    /// The whole way in C++: the dialog, the first build, the run, a mistake, its place, the repair, the new code in the running robot.
    void aControllerInCpp() {
        m_window->selection().select("rover");
        makeNew("Circler", false);
        QVERIFY(TrustedFolders::covers(path("circler")));
        QCOMPARE(QFileInfo(QString::fromStdString(page()->file())).fileName(), QStringLiteral("circler.cpp"));
        QCOMPARE(page()->edit().styling().language(), CodeLanguage::Cpp);
        awaitBuild();
        QVERIFY2(m_result->succeeded, qPrintable(m_result->failure));
        QVERIFY(m_result->messages.found.empty()); // no warning
        QVERIFY2(text().find("#loadModule circler/build/circler\n") != std::string::npos, text().c_str());
        QVERIFY2(text().find("Circler brain") != std::string::npos, text().c_str());
        QVERIFY(!m_window->document().loaded()->diagnostics.hasErrors());

        m_window->session().run();
        EVENTUALLY(value("rover/base/linearVelocity") > 0.1); // the template's Speed
        const std::string source = bytes();
        replace("drive.move(speed, turnRate);", "drive.move(-sped, turnRate);");
        QVERIFY(m_window->document().texts().isModified(page()->file()));
        build();
        QVERIFY(!m_result->succeeded && m_result->messages.found.size() == 1);
        const Diagnostic& wrong = m_result->messages.found[0];
        QCOMPARE(m_result->messages.sources->sources.slice(wrong.range), std::string_view("sped"));
        m_window->text().reveal(m_window->document().path(), {}, true);
        clickProblem();
        QCOMPARE(QFileInfo(QString::fromStdString(page()->file())).fileName(), QStringLiteral("circler.cpp"));
        QCOMPARE(selectedText(), std::string("sped"));
        QVERIFY(value("rover/base/linearVelocity") > 0.1); // the old code goes on

        replace("-sped", "-speed");
        build();
        QVERIFY(m_result->succeeded);
        EVENTUALLY(value("rover/base/linearVelocity") < -0.1);
        QVERIFY(m_window->session().results().time() > 0);
        QCOMPARE(problems().rowCount(), 0);
        QFile saved(path("circler/circler.cpp"));
        QVERIFY(saved.open(QIODevice::ReadOnly));
        QCOMPARE(saved.readAll().toStdString(), bytes()); // a build saves first

        m_window->document().edits().undo(); // typing in a source is in the same history
        m_window->document().edits().undo();
        QCOMPARE(bytes(), source);
        m_window->document().edits().undo(); // the use of the controller
        QCOMPARE(text(), kMain.toStdString());
        m_window->session().reset();
    }

    void aControllerInPython() {
        m_window->selection().select("rover");
        makeNew("Wander", true);
        QCOMPARE(page()->edit().styling().language(), CodeLanguage::Python);
        QVERIFY2(text().find("#loadModule wander/wander\n") != std::string::npos, text().c_str());
        QVERIFY2(text().find("Wander brain") != std::string::npos, text().c_str());
        m_window->session().run();
        EVENTUALLY(value("rover/base/linearVelocity") > 0.1);
        replace("self.drive.move(self.speed,", "self.drive.move(-self.speed,");
        m_window->actions().at("controllers.build").trigger(); // saves; there is nothing to build
        QVERIFY(!m_window->modules().builder().isRunning());
        QVERIFY(!m_window->document().texts().isModified());
        EVENTUALLY(value("rover/base/linearVelocity") < -0.1);
        m_window->session().reset();
    }

    /// It commands the drive that its robot has; the dialog says what it replaces.
    void aControllerOfASteeredRobot() {
        write("main.sim",
              "#import robots/car.sim\n#import arenas/open_floor.sim\nTick = 0.01\nStatic floor { Config=OpenFloor }\n"
              "Robot rover { Config=Car }\n");
        openWindow();
        m_window->selection().select("rover");
        makeNew("Wander", true);
        m_window->session().run();
        EVENTUALLY(value("rover/drive/linearVelocity") > 0.1);
        m_window->session().reset();
        m_window->selection().select("rover");
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); // the dialog
        m_window->actions().at("controllers.new").trigger();
        QCOMPARE(m_window->findChild<QCheckBox*>(QStringLiteral("moduleUse"))->text(),
                 QStringLiteral("&Use it for rover, in place of Wander"));
        m_window->findChild<QDialog*>(QStringLiteral("newModule"))->reject();
    }

    /// The next day: Files in the corner of the texts has the source.
    void aSourceIsFoundAgain() {
        m_window->selection().select("rover");
        makeNew("Wander", true);
        QVERIFY(m_window->document().saving().save().ok());
        openWindow();
        QVERIFY(!m_window->document().texts().text(path("wander/wander.py").toStdString()));
        auto* files = m_window->findChild<QToolButton*>(QStringLiteral("textFiles"));
        QVERIFY(files);
        Q_EMIT files->menu()->aboutToShow();
        const QList<QAction*> entries = files->menu()->actions();
        QCOMPARE(std::ranges::count_if(entries, [](QAction* a) { return a->text().endsWith(u"wander.py"); }), 1);
        entries.last()->trigger();
        QCOMPARE(page()->file(), path("wander/wander.py").toStdString());
        QCOMPARE(page()->edit().styling().language(), CodeLanguage::Python);
    }

    /// The selected robot keeps its controller.
    void aComponent() {
        m_window->selection().select("rover");
        makeNew("Wander", true);
        m_window->selection().select("rover");
        makeComponent("Feeler", false);
        awaitBuild();
        QVERIFY(text().find("Feeler") == std::string::npos && text().find("Wander brain") != std::string::npos);
        QVERIFY2(m_result->succeeded, qPrintable(m_result->failure));
        QVERIFY2(text().find("#loadModule feeler/build/feeler\n") != std::string::npos, text().c_str());
        QVERIFY(m_window->document().loaded()->registry->find("Feeler"));
    }

    /// Its reading follows the file at the next start.
    void aComponentInPython() {
        m_window->selection().select("rover");
        makeNew("Wander", true);
        m_window->selection().select("rover");
        const std::string before = text();
        makeComponent("Whisker", true);
        QVERIFY(text().find("Whisker") == std::string::npos && text().find("Wander brain") != std::string::npos);
        QCOMPARE(page()->edit().styling().language(), CodeLanguage::Python);
        m_window->document().edits().undo(); // one entry
        QCOMPARE(text(), before);
        m_window->document().edits().redo();
        QVERIFY2(text().find("#loadModule whisker/whisker\n") != std::string::npos, text().c_str());
        const Kind* kind = m_window->document().loaded()->registry->find("Whisker");
        QVERIFY(kind && kind->role == Role::Device && kind->find("MaxRange"));
        QVERIFY(m_window->text().openFile(path("main.sim").toStdString()));
        replace(
            "Robot rover {",
            "RobotConfig Scout { Body chassis { Box hull { Size=0.2,0.2,0.1 Pos=0,0,0.05 Mass=1 } }\n"
            "  Whisker eye { Body=chassis Pos=0.1,0,0.05 MaxRange=3 } }\nRobot scout { Config=Scout Pos=0,2,0 }\nRobot rover {");
        m_window->session().run();
        EVENTUALLY(value("scout/eye/distance") == 3);
        m_window->session().reset();
        QVERIFY(m_window->text().openFile(path("whisker/whisker.py").toStdString()));
        replace("self.distance = reading", "self.distance = reading + 1");
        m_window->actions().at("controllers.build").trigger(); // saves
        m_window->session().run();
        EVENTUALLY(value("scout/eye/distance") == 4);
        m_window->session().reset();
    }

    /// A field, then a mistake, then its repair: Properties, Problems and the state of the run follow each save, without a run.
    void savingPythonShowsWhatItChanged() {
        m_window->selection().select("rover");
        makeNew("Wander", true);
        m_window->selection().select("rover.brain");
        const auto row = [this](const char* name) {
            return m_window->findChild<QWidget*>(QStringLiteral("row.") + QLatin1String(name));
        };
        const auto state = [this] { return m_window->findChild<QLabel*>(QStringLiteral("transportState"))->text(); };
        QTest::qWait(200); // the first look at the files
        replace("    def setup(", "    extra = field(\"Extra\", 1.0, trundle.number(), \"More.\")\n\n    def setup(");
        QVERIFY(!m_window->document().loaded()->registry->find("Wander")->find("Extra"));
        m_window->actions().at("file.save").trigger();
        EVENTUALLY(m_window->document().loaded()->registry->find("Wander")->find("Extra"));
        EVENTUALLY(row("Extra"));
        replace("def update(self", "def update((self");
        m_window->actions().at("file.save").trigger();
        EVENTUALLY_EQUAL(problems().rowCount(), 1);
        QCOMPARE(problems().index(0, ProblemsModel::CodeColumn).data().toString(), QStringLiteral("E414"));
        QCOMPARE(state(), QStringLiteral("Cannot run"));
        replace("def update((self", "def update(self");
        m_window->actions().at("file.save").trigger();
        EVENTUALLY_EQUAL(problems().rowCount(), 0);
        QCOMPARE(state(), QStringLiteral("At start"));
        m_window->actions().at("sim.run").trigger();
        EVENTUALLY(value("rover/base/linearVelocity") > 0.1);
        m_window->session().reset();
    }

    /// The experiment with its edits, which runs as it is here, is not saved.
    void runSavesPython() {
        m_window->selection().select("rover");
        makeNew("Wander", true);
        m_window->actions().at("file.save").trigger();
        replace("self.drive.move(self.speed,", "self.drive.move(-self.speed,");
        QVERIFY(m_window->text().openFile(path("main.sim").toStdString()));
        replace("Robot rover {", "Robot rover { Pos=1,2,0");
        QCOMPARE(m_window->document().texts().modifiedFiles().size(), std::size_t(2));
        m_window->actions().at("sim.run").trigger();
        QCOMPARE(m_window->document().texts().modifiedFiles(), std::vector{path("main.sim").toStdString()});
        EVENTUALLY(value("rover/base/linearVelocity") < -0.1);
        m_window->actions().at("sim.pause").trigger();
        EVENTUALLY(m_window->session().state() == RunState::Paused);
        QVERIFY(m_window->text().openFile(path("wander/wander.py").toStdString()));
        replace("self.drive.move(-self.speed,", "self.drive.move(self.speed,");
        m_window->actions().at("sim.run").trigger(); // goes on, with the new code
        QVERIFY(!m_window->document().texts().isModified(page()->file()));
        EVENTUALLY(value("rover/base/linearVelocity") > 0.1);
        m_window->session().reset();
    }

    void namesThatCannotBe() {
        write("taken/x", "");
        m_window->actions().at("controllers.new").trigger();
        auto* dialog = m_window->findChild<QDialog*>(QStringLiteral("newModule"));
        QVERIFY(dialog);
        auto* name = dialog->findChild<QLineEdit*>(QStringLiteral("moduleName"));
        auto* create = dialog->findChild<QPushButton*>(QStringLiteral("moduleCreate"));
        for (const char* bad : {"", "wall", "Wall Follow", "RotaryMotor", "LinearMotion", "Taken"}) {
            name->setText(QLatin1String(bad));
            QVERIFY2(!create->isEnabled(), bad);
        }
        name->setText(QStringLiteral("WallFollow2"));
        QVERIFY(create->isEnabled());
        dialog->findChild<QLineEdit*>(QStringLiteral("moduleFolder"))->setText(QStringLiteral("/tmp"));
        QVERIFY(!create->isEnabled());
        dialog->reject();
    }

    /// Its commands would write a file.
    void anUntrustedFolderIsNotBuilt() {
        write("evil/CMakeLists.txt", "cmake_minimum_required(VERSION 3.25)\nproject(evil NONE)\nfile(WRITE ${CMAKE_SOURCE_DIR}/ran \"\")\n");
        write("evil/evil.cpp", "int a;\n");
        int asked = 0;
        bool answer = false;
        m_window->findChild<ControllersPanel*>()->commands().setAsk([&](const QString&, const QString& folder) {
            ++asked;
            return answer && folder == path("evil");
        });
        QVERIFY(m_window->text().openFile(path("evil/evil.cpp").toStdString()));
        m_window->actions().at("controllers.build").trigger();
        QVERIFY(asked == 1 && !m_window->modules().builder().isRunning() && !QFile::exists(path("evil/ran")));
        answer = true;
        build();
        QVERIFY(asked == 2 && QFile::exists(path("evil/ran")));
        build();
        QCOMPARE(asked, 2);
    }

    /// Its problem has a fix that asks, as the button in the Controllers panel does.
    void theProblemOfAnUntrustedModuleAsksForTrust() {
        write("evil/loop.py",
              "import trundle\n\n\nclass Loop(trundle.Controller):\n    \"\"\"Loops.\"\"\"\n\n    def setup(self, robot):\n"
              "        pass\n\n    def update(self, since_last):\n        pass\n");
        write("main.sim", kMain + "#loadModule evil/loop.py\n");
        openWindow();
        QString asked;
        m_window->findChild<ControllersPanel*>()->commands().setAsk([&](const QString&, const QString& folder) {
            asked = folder;
            return true;
        });
        QCOMPARE(problems().index(0, ProblemsModel::CodeColumn).data().toString(), QStringLiteral("E402"));
        m_window->findChild<QTreeView*>(QStringLiteral("problems"))->setCurrentIndex(problems().index(0, 0));
        m_window->findChild<ProblemsPanel*>()->fixCurrent();
        QCOMPARE(asked, path("evil"));
        QVERIFY(m_window->document().loaded()->registry->find("Loop"));
        QCOMPARE(problems().rowCount(), 0);
    }

    void cancels() {
        write("slow/CMakeLists.txt",
              "cmake_minimum_required(VERSION 3.25)\nproject(slow NONE)\nexecute_process(COMMAND sleep 600)\n");
        write("slow/slow.cpp", "int a;\n");
        TrustedFolders::add(path("slow"));
        m_window->findChild<ControllersPanel*>()->commands().applyTrust();
        QVERIFY(m_window->text().openFile(path("slow/slow.cpp").toStdString()));
        m_window->actions().at("controllers.build").trigger();
        QVERIFY(m_window->modules().builder().isRunning() && !m_window->actions().at("controllers.build").isEnabled());
        m_window->actions().at("controllers.cancelBuild").trigger();
        awaitBuild();
        QVERIFY(m_result->cancelled && !m_result->succeeded);
        QVERIFY(m_window->actions().at("controllers.build").isEnabled());
    }

private:
    void openWindow() {
        m_window.reset();
        m_window = std::make_unique<MainWindow>(*m_application, nullptr, findLocations());
        m_window->show();
        QVERIFY(m_window->open(path("main.sim")));
        EVENTUALLY(m_window->document().isOpen());
    }
    [[nodiscard]] QString path(const char* name) const {
        return QDir(m_folder->path()).canonicalPath() + u'/' + QLatin1String(name);
    }
    void write(const char* name, const QByteArray& bytes) const {
        QVERIFY(QDir().mkpath(QFileInfo(path(name)).path()));
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(bytes);
    }
    [[nodiscard]] FilePage* page() const { return m_window->text().page(); }
    [[nodiscard]] std::string bytes() const { return *m_window->document().texts().text(page()->file()); }
    [[nodiscard]] std::string text() const { return *m_window->document().texts().text(m_window->document().path()); }
    [[nodiscard]] std::string selectedText() const {
        const TextRange range = page()->edit().selection();
        return page()->edit().bytes().substr(range.begin, range.size());
    }
    [[nodiscard]] QAbstractItemModel& problems() const {
        return *m_window->findChild<ProblemsPanel*>()->findChild<QTreeView*>()->model();
    }
    void clickProblem() {
        auto* view = m_window->findChild<ProblemsPanel*>()->findChild<QTreeView*>();
        const QModelIndex first = view->model()->index(0, 0);
        QVERIFY(first.isValid());
        QCOMPARE(view->model()->index(0, ProblemsModel::CodeColumn).data().toString(), QStringLiteral("build"));
        Q_EMIT view->clicked(first);
    }
    void makeNew(const char* kind, bool python) {
        m_window->actions().at("controllers.new").trigger();
        auto* dialog = m_window->findChild<QDialog*>(QStringLiteral("newModule"));
        QVERIFY(dialog);
        dialog->findChild<QLineEdit*>(QStringLiteral("moduleName"))->setText(QLatin1String(kind));
        if (python) dialog->findChild<QRadioButton*>(QStringLiteral("modulePython"))->click();
        QVERIFY(dialog->findChild<QCheckBox*>(QStringLiteral("moduleUse"))->text().contains(QStringLiteral("rover")));
        dialog->findChild<QPushButton*>(QStringLiteral("moduleCreate"))->click();
        QVERIFY(page());
    }
    void makeComponent(const char* kind, bool python) {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); // an earlier dialog
        m_window->actions().at("controllers.newComponent").trigger();
        auto* dialog = m_window->findChild<QDialog*>(QStringLiteral("newModule"));
        QVERIFY(dialog);
        if (python) dialog->findChild<QRadioButton*>(QStringLiteral("modulePython"))->click();
        dialog->findChild<QLineEdit*>(QStringLiteral("moduleName"))->setText(QLatin1String(kind));
        dialog->findChild<QPushButton*>(QStringLiteral("moduleCreate"))->click();
    }
    /// Types over the first place of a text.
    void replace(const char* from, const char* to) {
        const std::string now = page()->edit().bytes();
        const auto at = static_cast<std::uint32_t>(now.find(from));
        QVERIFY(at < now.size());
        page()->endWord();
        page()->edit().type({at, at + static_cast<std::uint32_t>(strlen(from))}, to, at);
        m_window->text().flush();
    }
    void awaitBuild() { QTRY_VERIFY_WITH_TIMEOUT(m_result.has_value(), kBuildMs); }
    void build() {
        m_result.reset();
        m_window->actions().at("controllers.build").trigger();
        awaitBuild();
    }
    [[nodiscard]] double value(const char* signal) const {
        return valueOf(m_window->session().results(), signal);
    }

    std::unique_ptr<Application> m_application;
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<MainWindow> m_window;
    std::optional<BuildResult> m_result;
};

QTEST_MAIN(ModulesTest)
#include "modules_test.moc"
