// The order of the problems, stepping through them, and what the check of the robots is started with.
#include <QTest>
#include <QTreeView>

#include "editor/problems/problems_panel.h"
#include "editor/problems/robots_check.h"
#include "editor/problems/rows_fixture.h"

using namespace trundle;

class ProblemRowsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// The check of the robots finds it too, but not its line in the source of the controller.
    void aFaultInCodeIsListedOnce() {
        RowsFixture fixture;
        QVERIFY(fixture.open("Tick = 0.01\n"));
        ProblemsModel model;
        model.setLoaded(fixture.document.loaded());
        Diagnostic ofRun = problem("no port", {0, {1, 2}});
        ofRun.place = {"/elsewhere/mind.py", 7};
        model.setRun({ofRun}, fixture.document.loaded());
        model.setModelProblems({problem("no port", {0, {1, 2}}), problem("odd wheel", {0, {1, 2}})}, fixture.document.loaded());
        QCOMPARE(messagesOf(model), QByteArray("no port, odd wheel"));
    }

    /// What concerns the whole project is first, then by place; or by severity, and then so.
    void order() {
        RowsFixture fixture;
        QVERIFY(fixture.open("Tick = 0.01\n"));
        ProblemsModel model;
        model.setLoaded(fixture.document.loaded());
        model.setModelProblems({problem("late", {0, {9, 10}}), problem("of all", {}, Severity::Warning),
                                problem("early", {0, {1, 2}}), problem("hint", {0, {4, 5}}, Severity::Hint),
                                problem("of all too", {})},
                               fixture.document.loaded());
        QCOMPARE(messagesOf(model), QByteArray("of all, of all too, early, hint, late"));
        model.setOrder(ProblemOrder::Severity);
        QCOMPARE(messagesOf(model), QByteArray("of all too, early, late, of all, hint"));
    }

    /// By letters of the message or of the code.
    void filter() {
        RowsFixture fixture;
        QVERIFY(fixture.open("Tick = 0.01\n"));
        Diagnostic other = problem("No module", {0, {3, 4}}, Severity::Warning);
        other.code = Code::ControllerFailed;
        ProblemsModel model;
        model.setLoaded(fixture.document.loaded());
        model.setModelProblems({problem("odd wheel", {0, {1, 2}}), other}, fixture.document.loaded());
        const QString odd = QString::fromStdString(codeName(Code::OddInertia)),
                      failed = QString::fromStdString(codeName(Code::ControllerFailed));
        QVERIFY(odd != failed);
        const auto found = [&](const QString& words, bool errors = true, bool warnings = true) {
            model.setFilter(errors, warnings, words);
            return messagesOf(model);
        };
        QCOMPARE(found({}), QByteArray("odd wheel, No module"));
        QCOMPARE(found(odd), QByteArray("odd wheel"));
        QCOMPARE(found(failed), QByteArray("No module"));
        QCOMPARE(found(failed.toLower()), QByteArray("No module"));
        QCOMPARE(found(odd.mid(1)), QByteArray("odd wheel"));
        QCOMPARE(found(QStringLiteral("MODULE")), QByteArray("No module"));
        QCOMPARE(found(odd + failed), QByteArray());
        QCOMPARE(found(odd, false), QByteArray());
        QCOMPARE(found(failed, false), QByteArray("No module"));
        QCOMPARE(found(failed, true, false), QByteArray());
        QCOMPARE(model.errors(), 1); // of all
        QCOMPARE(model.warnings(), 1);
    }

    /// A note has a place of its own, a fix that of its problem.
    void placesOfNotes() {
        RowsFixture fixture;
        QVERIFY(fixture.open("Tick = 0.01 // as text\n"));
        Diagnostic first = problem("first", {0, {1, 2}}), second = problem("second", {0, {3, 4}});
        first.notes = {{"here", {0, {5, 6}}}};
        second.notes = {{"there", {0, {7, 8}}}, {"and there", {0, {9, 10}}}};
        second.fixes = {{"x", {TextEdit{{0, {3, 4}}, "x"}}}};
        ProblemsModel model;
        model.setLoaded(fixture.document.loaded());
        model.setModelProblems({first, second}, fixture.document.loaded());
        const auto begin = [&](int row, std::optional<int> child = {}) {
            const QModelIndex parent = model.index(row, 0);
            return model.placeAt(child ? model.index(*child, 0, parent) : parent).range.begin;
        };
        QCOMPARE(begin(0), 1u);
        QCOMPARE(begin(0, 0), 5u);
        QCOMPARE(begin(1), 3u);
        QCOMPARE(begin(1, 0), 7u);
        QCOMPARE(begin(1, 1), 9u);
        QCOMPARE(begin(1, 2), 3u);
        QCOMPARE(model.diagnosticAt(model.index(1, 0, model.index(0, 0))), nullptr);
        QCOMPARE(model.placeAt({}).range.end, 0u);
    }

    void steps_data() {
        QTest::addColumn<int>("step");
        QTest::addColumn<QList<int>>("rows");
        QTest::newRow("ahead") << 1 << QList<int>{0, 1, 2, 0};
        QTest::newRow("back") << -1 << QList<int>{2, 1, 0, 2};
    }
    /// Where none is current, the first step leads to the first row, or back to the last one.
    void steps() {
        QFETCH(int, step);
        QFETCH(QList<int>, rows);
        RowsFixture fixture;
        ProblemsPanel panel(fixture.document, fixture.selection);
        panel.goTo(step); // nothing is open
        QVERIFY(fixture.open("Tikc = 0.01\nDuratoin = 1\nGravty = 0,0,-9\n"));
        const auto* view = panel.findChild<QTreeView*>(QStringLiteral("problems"));
        QVERIFY(!view->currentIndex().isValid());
        QList<int> found;
        for (qsizetype i = 0; i < rows.size(); ++i) {
            panel.goTo(step);
            found << view->currentIndex().row();
        }
        QCOMPARE(found, rows);
    }

    /// A click opens the source at the line of the mistake, also in a file that it imports; the note leads to the #loadModule.
    void aModuleInPythonIsAtItsLine_data() {
        QTest::addColumn<QByteArray>("helper");
        QTest::addColumn<QByteArray>("mind");
        QTest::addColumn<QString>("place");
        QTest::newRow("its own") << QByteArray("X = 1\n") << QByteArray("import helper\n\n\n  def setup(:\n")
                                 << QStringLiteral("mind.py:4:3");
        QTest::newRow("imported") << QByteArray("X = 1\nY = = 2\n") << QByteArray("import helper\n")
                                  << QStringLiteral("helper.py:2:1");
    }
    void aModuleInPythonIsAtItsLine() {
        QFETCH(QByteArray, helper);
        QFETCH(QByteArray, mind);
        QFETCH(QString, place);
        RowsFixture fixture;
        OpenOptions options;
        options.trust = true;
        fixture.document.setOptions(options);
        ProblemsPanel panel(fixture.document, fixture.selection);
        std::filesystem::create_directories(fixture.path("configs"));
        std::ofstream(fixture.path("configs/helper.py")) << helper.constData();
        std::ofstream(fixture.path("configs/mind.py")) << mind.constData();
        QVERIFY(fixture.open("Tick = 0.01\n#loadModule mind.py\n"));
        auto* view = panel.findChild<QTreeView*>(QStringLiteral("problems"));
        const QAbstractItemModel& rows = *view->model();
        QCOMPARE(rows.rowCount(), 1);
        QCOMPARE(rows.index(0, ProblemsModel::Place).data().toString(), place);
        std::vector<std::string> opened;
        connect(&panel, &ProblemsPanel::jumpTo, this, [&](const std::string& file, const SourceRange&) {
            opened.push_back(std::filesystem::path(file).filename().string());
        });
        const QModelIndex row = rows.index(0, 0);
        QCOMPARE(rows.rowCount(row), 1);
        QCOMPARE(rows.index(0, ProblemsModel::Place, row).data().toString(), QStringLiteral("main.sim:2:13"));
        Q_EMIT view->clicked(row);
        Q_EMIT view->clicked(rows.index(0, 0, row));
        QCOMPARE(opened, (std::vector<std::string>{place.section(u':', 0, 0).toStdString(), "main.sim"}));
        std::ofstream(fixture.path("configs/mind.py")) << "import trundle\n";
        std::ofstream(fixture.path("configs/helper.py")) << "X = 1\n";
        fixture.document.loading().readAgain();
        QVERIFY(rows.rowCount() == 0 || !rows.index(0, ProblemsModel::Place).data().toString().contains(place));
    }

    /// The program gets the options that the document was opened with, the texts and the file.
    void argumentsOfTheRobotsCheck() {
        RowsFixture fixture;
        QVERIFY(fixture.open(
            "#loadModule controllers/none\nRobotConfig C { Body b { Sphere s { Radius=1 Mass=1 } } }\nRobot r { Config=C }\n"));
        const std::string program = fixture.path("program.sh"), words = fixture.path("words.txt"),
                          input = fixture.path("input.json");
        std::ofstream(program) << "#!/bin/sh\nprintf '%s\\n' \"$@\" > '" << words << "'\ncat > '" << input << "'\necho '[]'\n";
        std::filesystem::permissions(program, std::filesystem::perms::owner_all);
        RobotsCheck check;
        check.program = program;
        check.options.includes = {"/one", "/two"};
        check.options.modules = {"/mods"};
        check.options.sets = {"Tick=0.002", "r.b.s.Mass=3"};
        check.options.trust = true;
        QVERIFY(checkRobots(check, *fixture.document.loaded(), {}).empty());
        const auto bytesOf = [](const std::string& path) {
            std::ifstream file(path, std::ios::binary);
            return std::string(std::istreambuf_iterator<char>(file), {});
        };
        QCOMPARE(bytesOf(words),
                 "check\n--robots-of-texts\n-I\n/one\n-I\n/two\n--modules\n/mods\n--set\nTick=0.002\n--set\nr.b.s.Mass=3\n"
                 "--trust\n--\n" +
                     fixture.document.loaded()->paths[0] + "\n");
        QVERIFY(bytesOf(input).find("Radius=1 Mass=1") != std::string::npos);
        check.options = {};
        QVERIFY(checkRobots(check, *fixture.document.loaded(), {}).empty());
        QCOMPARE(bytesOf(words), "check\n--robots-of-texts\n--\n" + fixture.document.loaded()->paths[0] + "\n");
    }

    /// What the program finds is shown in the file that it names, which may be an imported one.
    void placesOfTheRobotsCheck_data() {
        QTest::addColumn<bool>("isRun"); // the module has ended the process
        QTest::newRow("a list") << false;
        QTest::newRow("of a run") << true;
    }
    void placesOfTheRobotsCheck() {
        QFETCH(bool, isRun);
        RowsFixture fixture;
        std::filesystem::create_directories(fixture.path("configs"));
        for (const char* name : {"C", "D"})
            std::ofstream(fixture.path("configs/") + name + ".sim")
                << "RobotConfig " << name << " { Body b { Sphere s { Radius=1 Mass=1 } } }\n";
        QVERIFY(fixture.open("#import C.sim\n#import D.sim\n#loadModule controllers/none\nRobot r { Config=D }\n"));
        const LoadedProject& loaded = *fixture.document.loaded();
        QCOMPARE(loaded.paths.size(), std::size_t(3));
        std::string list;
        for (const auto& [file, begin] :
             {std::pair(loaded.paths[2], 4), {loaded.paths[0], 5}, {loaded.paths[1], 6}, {"/none", 7}})
            list += (list.empty() ? "" : ",") + std::string("{\"code\":\"E601\",\"message\":\"m") + std::to_string(begin) +
                    "\",\"file\":\"" + file + "\",\"begin\":" + std::to_string(begin) + ",\"end\":" + std::to_string(begin + 3) +
                    "}";
        const std::string json = isRun ? "{\"diagnostics\":[" + list + "]}" : "[" + list + "]",
                          program = fixture.path("program.sh");
        std::ofstream(program) << "#!/bin/sh\ncat > /dev/null\necho '" << json << "'\n";
        std::filesystem::permissions(program, std::filesystem::perms::owner_all);
        RobotsCheck check;
        check.program = program;
        const std::vector<Diagnostic> found = checkRobots(check, loaded, {});
        QCOMPARE(found.size(), std::size_t(4));
        const FileId files[] = {2, 0, 1};
        for (std::uint32_t i = 0; i < 4; ++i) {
            QCOMPARE(found[i].message, "m" + std::to_string(4 + i));
            QCOMPARE(static_cast<int>(found[i].code), 601);
            QVERIFY(found[i].severity == Severity::Error);
            if (i == 3) break;
            QCOMPARE(found[i].range.file, files[i]);
            QCOMPARE(found[i].range.range.begin, 4 + i);
            QCOMPARE(found[i].range.range.end, 7 + i);
        }
        QCOMPARE(found[3].range.range.end, 0u); // in none of the texts
    }
};

QTEST_MAIN(ProblemRowsTest)
#include "problem_rows_test.moc"
