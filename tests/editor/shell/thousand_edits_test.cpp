// Random edits of every kind, with runs in between: after each the modified mark is right; at the end undoing all restores the
// original bytes, and redoing all restores the final ones. TRUNDLE_SEED sets another seed.

#include <set>

#include <QAbstractButton>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QMessageBox>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

#include "editor/outline/library_panel.h"
#include "editor/shell/random_user.h"
#include "editor/shell/window_fixture.h"
#include "editor/text/code/code_edit.h"
#include "editor/text/pages/file_page.h"
#include "editor/text/text_panel.h"
#include "eventually.h"

using namespace trundle;

namespace {

const QByteArray kExperiment =
    "// mine\n"
    "Tick = 0.01\n"
    "#import robots/simple_robot.sim\n"
    "#import arenas/medium_arena.sim\n"
    "#loadModule controllers/linear_motion\n"
    "Static arena { Config=MediumArena }\n"
    "Robot robot0 {\n"
    "  Config=SimpleRobot  Pos=-1,0,0   // where it starts\n"
    "  LinearMotion brain { Distance=1.0 Speed=0.2 }\n"
    "}\n"
    "Robot robot1 { Config=SimpleRobot Pos=1, 0.5, 0 HPR=90,0,0 leftMotor.Resistance=3 }\n"
    "PoseLog path { Robot=robot0 Interval=0.1 File=path.csv }\n"
    "\n"
    "// driven\n"
    "PartConfig Wheel {\n"
    "  Param r = 5 cm { Min=1 cm Max=20 cm Help=\"of the tyre\" }\n"
    "  Body wheel { Cylinder tyre { Radius=$r Length=0.03 HPR=0,0,90 Mass=0.15 Material=black Surface=rubber } }\n"
    "  // turns\n"
    "  Hinge axle { Parent=$carrier Child=wheel Axis=0,1,0 }\n"
    "}\n"
    "RobotConfig Kit {\n"
    "  Body chassis { Box hull { Size=0.3,0.2,0.1 Pos=0,0,0.09 Mass=2 Material=orange Surface=plastic }\n"
    "    Repeat bolt { Count=3 Pos=$(0.1*index - 0.1),0,0.15 Sphere head { Radius=0.01 Mass=0.01 Material=grey Surface=plastic } "
    "} }\n"
    "  Part left { Config=Wheel Pos=0.06,0.125,0.05 carrier=chassis } // mirrored below\n"
    "  Part right { Config=Wheel Pos=0.06,-0.125,0.05 Mirror=y carrier=chassis }\n"
    "}\n"
    "RobotConfig BigKit { Config=Kit left.r=0.06 }\n"
    "Robot kit { Config=BigKit Pos=0,-1,0.01 right.r=0.06 }\n"
    "Ring posts { Count=3 Radius=1.2 Robot post { Config=Kit } }\n";

using Texts = std::map<std::string, std::string>;

} // namespace

class ThousandEditsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        m_fixture.start();
        // Closes message boxes.
        connect(&m_reader, &QTimer::timeout, this, [] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (box && box->objectName() != QStringLiteral("shareQuestion")) box->buttons().first()->click();
        });
        m_reader.start(5);
    }
    void init() {
        QSettings().clear();
        m_folder = std::make_unique<QTemporaryDir>();
        write("mine.sim", kExperiment);
        for (const char* name : {"robots/simple_robot.sim", "arenas/medium_arena.sim"}) {
            QFile sample(QStringLiteral(TRUNDLE_SOURCE_DIR "/configs/") + QLatin1String(name));
            QVERIFY(sample.open(QIODevice::ReadOnly));
            write(name, sample.readAll());
        }
        m_window = m_fixture.window();
        m_window->show();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get(), kTimeoutMs));
        QVERIFY(m_window->open(path("mine.sim")));
        EVENTUALLY(document().isOpen());
        QVERIFY(!document().loaded()->diagnostics.hasErrors());
        EVENTUALLY(!m_window->findChild<LibraryPanel*>()->isReading());
        m_window->session().setSpeed(0);
        m_known.clear();
    }
    void cleanup() {
        if (QTest::currentTestFailed()) {
            qWarning("TRUNDLE_SEED=%u, step %d: %s", m_seed, m_step, qPrintable(m_action));
            const auto& entries = document().edits().history().entries();
            for (std::size_t i = entries.size() < 5 ? 0 : entries.size() - 5; i < entries.size(); ++i)
                qWarning("  entry %zu: %s", i + 1, qPrintable(entries[i].name));
        }
        m_window.reset();
        m_folder.reset();
    }

    void undoAllRedoAll_data() {
        QTest::addColumn<unsigned>("seed");
        const unsigned first = qEnvironmentVariableIsSet("TRUNDLE_SEED") ? qEnvironmentVariable("TRUNDLE_SEED").toUInt() : 1;
        const unsigned seeds = qEnvironmentVariableIsSet("TRUNDLE_LONG") ? 2 : 1;
        for (unsigned seed = first; seed < first + seeds; ++seed) QTest::addRow("seed %u", seed) << seed;
    }
    void undoAllRedoAll() {
        QFETCH(unsigned, seed);
        m_seed = seed;
        const int edits = qEnvironmentVariableIsSet("TRUNDLE_LONG") ? 1000 : 60;
        const Texts start = texts();
        RandomUser user(*m_window, seed);
        for (m_step = 1; m_step <= edits; ++m_step) {
            user.step();
            if (qEnvironmentVariableIsSet("TRUNDLE_VERBOSE"))
                qInfo("step %d: %s; %zu of %zu", m_step, user.doing(), document().edits().history().position(),
                      document().edits().history().entries().size());
            m_action = QLatin1String(user.doing());
            QVERIFY2(user.trouble().isEmpty(), qPrintable(user.trouble()));
            check();
            if (QTest::currentTestFailed()) return;
        }
        QVERIFY2(document().edits().history().entries().size() > 5, "too little came of it");
        m_answers.insert(user.answers().begin(), user.answers().end());
        if (edits == 1000) QVERIFY2(!user.answers().empty(), "nothing was ever asked about a shared config");

        m_action = QStringLiteral("redo all");
        goThrough("edit.redo");
        const Texts end = texts();
        m_action = QStringLiteral("undo all");
        goThrough("edit.undo");
        compare(start);
        m_action = QStringLiteral("redo all again");
        goThrough("edit.redo");
        compare(end);
    }

    void everyAnswerAboutASharedConfigWasGiven() {
        if (!qEnvironmentVariableIsSet("TRUNDLE_LONG")) return; // a short walk may not cause a question
        for (const char* answer : {"changeForAll", "makeCopy", "cancel"}) QVERIFY2(m_answers.contains(answer), answer);
    }

private:
    [[nodiscard]] Document& document() { return m_window->document(); }
    [[nodiscard]] QString path(const char* name) const {
        return QDir(m_folder->path()).canonicalPath() + QStringLiteral("/configs/") + QLatin1String(name);
    }
    void write(const char* name, const QByteArray& bytes) const {
        const QString to = path(name);
        QVERIFY(QDir().mkpath(QFileInfo(to).path()));
        QFile file(to);
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(bytes), bytes.size());
    }
    static std::string onDisk(const std::string& path) {
        QFile file(QString::fromStdString(path));
        return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
    }
    [[nodiscard]] Texts texts() {
        m_window->text().flush();
        Texts all;
        for (const std::string& file : document().texts().files()) all.emplace(file, *document().texts().text(file));
        return all;
    }
    void compare(const Texts& wanted) {
        for (const auto& [file, text] : wanted) QCOMPARE(*document().texts().text(file), text);
        const Texts now = texts();
        QCOMPARE(now.size(), wanted.size());
        check();
    }
    void goThrough(const char* action) {
        while (m_window->actions().at(action).isEnabled()) {
            const std::size_t before = document().edits().history().position();
            m_window->actions().at(action).trigger();
            QVERIFY(document().edits().history().position() != before);
            check();
            if (QTest::currentTestFailed()) return;
        }
    }

    /// All parts of the window show the same text, and files that differ from the disk are marked as modified.
    void check() {
        m_window->text().flush();
        Document& d = document();
        for (const std::string& file : d.texts().files()) m_known.insert(file);
        bool modified = false;
        for (const std::string& file : m_known) {
            const bool differs = onDisk(file) != *d.texts().text(file);
            QVERIFY2(d.texts().isModified(file) == differs, file.c_str());
            modified = modified || differs;
        }
        QCOMPARE(d.texts().isModified(), modified);
        QCOMPARE(m_window->isWindowModified(), modified);
        for (const FilePage* page : m_window->text().pages()) {
            QVERIFY(!page->pending());
            QCOMPARE(const_cast<FilePage*>(page)->edit().bytes(), *d.texts().text(page->file()));
        }
        QCOMPARE(m_window->actions().at("edit.undo").isEnabled(), d.edits().history().canUndo());
        QCOMPARE(m_window->actions().at("edit.redo").isEnabled(), d.edits().history().canRedo());
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    WindowFixture m_fixture;
    std::unique_ptr<MainWindow> m_window;
    QTimer m_reader;
    std::set<std::string> m_known;        // all files that were ever part of the project
    std::map<std::string, int> m_answers; // of all walks
    unsigned m_seed = 0;
    int m_step = 0;
    QString m_action;
};

QTEST_MAIN(ThousandEditsTest)
#include "thousand_edits_test.moc"
