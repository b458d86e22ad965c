// The order of the problems, stepping through them, and what the check of the robots is started with.
#include <filesystem>
#include <fstream>

#include <QTemporaryDir>
#include <QTest>
#include <QTreeView>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/problems/problems_model.h"
#include "editor/problems/problems_panel.h"
#include "editor/problems/robots_check.h"

using namespace trundle;

namespace {

/// A document of an experiment in a folder of its own.
struct RowsFixture {
    QTemporaryDir folder;
    std::unique_ptr<Application> application = makeApplication();
    Document document{*application};
    Selection selection;

    [[nodiscard]] std::string path(const char* name) const {
        return (std::filesystem::path(folder.path().toStdString()) / name).string();
    }
    bool open(const std::string& text) {
        std::filesystem::create_directories(path("configs"));
        std::ofstream(path("configs/main.sim"), std::ios::binary) << text;
        return document.opening().open(path("configs/main.sim")).ok();
    }
};

Diagnostic problem(const char* message, SourceRange range, Severity severity = Severity::Error) {
    Diagnostic d;
    d.severity = severity;
    d.code = Code::OddInertia;
    d.message = message;
    d.range = range;
    return d;
}

QByteArray messagesOf(const QAbstractItemModel& model) {
    QStringList all;
    for (int i = 0; i < model.rowCount(); ++i) all << model.index(i, ProblemsModel::Message).data().toString();
    return all.join(QStringLiteral(", ")).toUtf8();
}

} // namespace

class ProblemRowsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
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
};

QTEST_MAIN(ProblemRowsTest)
#include "problem_rows_test.moc"
