// What the window says of a run: speeds, times, the status line, the lines of the console, trusted folders; and edits of Views.
#include <QSettings>
#include <QSignalSpy>
#include <QtTest>

#include <trundle/abi.h>

#include "editor/running/live_edits.h"
#include "editor/running/panels/console_model.h"
#include "editor/running/panels/controller_commands.h"
#include "editor/running/panels/run_status.h"
#include "editor/running/panels/speeds.h"
#include "editor/running/panels/trust.h"
#include "editor/running/session_fixture.h"
#include "editor/widgets/theme.h"
#include "eventually.h"

using namespace trundle;

namespace {

/// Two robots and a crate.
const QByteArray kThings = kStandingRobot + "Robot robot1 { Config=SimpleRobot Pos=1,0,0 }\n"
                                            "RobotConfig Crate { Body b { Box g { Size=0.2,0.2,0.2 Mass=1 } } }\n"
                                            "Robot crate { Config=Crate Pos=0,1,0.1 }\n";

} // namespace

class RunTextsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() { QSettings().clear(); }
    void cleanup() { QSettings().clear(); }

    /// The model check finds it, not the reading of the text.
    void aRunThatCannotBeBuiltSaysSo() {
        SessionFixture o;
        QVERIFY(o.open(QByteArray(kStandingRobot) + "SignalLog log { Signals=robot0/ba }\n"));
        QSignalSpy refused(&o.session.messages(), &RunMessages::refused);
        o.session.run();
        EVENTUALLY_EQUAL(refused.size(), 1);
        QVERIFY2(refused[0][0].toString().contains(QStringLiteral("robot0/ba")), qPrintable(refused[0][0].toString()));
        EVENTUALLY_EQUAL(o.session.state(), RunState::Start);
    }

    void speeds() {
        const std::pair<double, int> nearest[] = {{0, 7},    {-1, 7},   {1e-9, 0}, {0.1, 0}, {0.157, 0}, {0.16, 1},
                                                  {0.25, 1}, {0.36, 2}, {0.71, 3}, {1, 3},   {1.41, 3},  {1.42, 4},
                                                  {3.1, 4},  {3.2, 5},  {7.0, 5},  {7.1, 6}, {10, 6},    {1e9, 6}};
        for (const auto& [factor, index] : nearest) QVERIFY2(speedIndex(factor) == index, qPrintable(QString::number(factor)));
        for (const auto& [factor, text] : {std::pair{0.25, "0.25×"}, {10., "10×"}, {0., "max"}, {-1., "max"}})
            QCOMPARE(speedText(factor), QString::fromUtf8(text));
        for (const auto& [seconds, text] : {std::pair{0., "t = 0.00 s"},
                                            {3599.99, "t = 3599.99 s"},
                                            {3600., "t = 1:00:00.0"},
                                            {3725.5, "t = 1:02:05.5"},
                                            {39599.9, "t = 10:59:59.9"},
                                            {360000., "t = 100:00:00.0"}})
            QCOMPARE(timeText(seconds), QLatin1String(text));
        for (const auto& [factor, text] :
             {std::pair{0.004, "0.00×"}, {0.994, "0.99×"}, {0.996, "1.0×"}, {9.94, "9.9×"}, {9.96, "10×"}, {41.4, "41×"}})
            QCOMPARE(factorText(factor), QString::fromUtf8(text));
    }

    /// A module of another project is not found by its name alone, as by trundle-cli; by its path it is trusted.
    void trustedFoldersAreNotSearched() {
        SessionFixture o;
        QVERIFY(QDir(o.folder.path()).mkpath(QStringLiteral("other")));
        for (const char* ending : {".so", ".so.kinds.json"})
            QVERIFY(
                QFile::copy(QStringLiteral(TRUNDLE_BINARY_DIR "/lib/trundle/controllers/librandom_drive") + QLatin1String(ending),
                            o.path("other/libwander") + QLatin1String(ending)));
        TrustedFolders::add(o.path("other"));
        const ControllerCommands commands(o.document, o.session); // which knows the trusted folders
        for (const auto& [written, isFound] : {std::pair("wander", false), {"other/wander", true}}) {
            QVERIFY(o.open(kStandingRobot + "#loadModule " + written + "\n"));
            const std::vector<Diagnostic> found = o.document.loaded()->diagnostics.all();
            QCOMPARE(std::ranges::count(found, Code::ModuleNotFound, &Diagnostic::code), isFound ? 0 : 1);
            QCOMPARE(commands.modules().at(0).library.empty(), !isFound);
            QVERIFY(!isFound || commands.modules()[0].trusted);
        }
    }

    void trustedFoldersCoverWhatIsBelowThem() {
        QTemporaryDir made;
        const QString root = QDir(made.path()).canonicalPath();
        for (const char* folder : {"mods/deep", "mods2", "link"}) QVERIFY(QDir(root).mkpath(QLatin1String(folder)));
        QVERIFY(QFile::link(root + QStringLiteral("/mods"), root + QStringLiteral("/alias")));
        TrustedFolders::add(root + QStringLiteral("/link/../mods"));
        QCOMPARE(TrustedFolders::all(), QStringList{root + QStringLiteral("/mods")});
        for (const char* inside : {"/mods", "/mods/", "/mods/deep", "/alias", "/alias/deep"})
            QVERIFY2(TrustedFolders::covers(root + QLatin1String(inside)), inside);
        for (const char* outside : {"", "/mods2", "/mod", "/mods/../mods2", "/link"})
            QVERIFY2(!TrustedFolders::covers(root + QLatin1String(outside)), outside);
        TrustedFolders::add(root + QStringLiteral("/mods/deep")); // covered already
        QCOMPARE(TrustedFolders::all().size(), 1);
        TrustedFolders::add(root + QStringLiteral("/mods2"));
        QCOMPARE(TrustedFolders::all(), (QStringList{root + QStringLiteral("/mods"), root + QStringLiteral("/mods2")}));
        TrustedFolders::remove(root + QStringLiteral("/alias")); // another name of it
        QCOMPARE(TrustedFolders::all(), QStringList{root + QStringLiteral("/mods2")});
        QVERIFY(!TrustedFolders::covers(root + QStringLiteral("/mods")));
        TrustedFolders::add(QStringLiteral("/"));
        QVERIFY(TrustedFolders::covers(root + QStringLiteral("/mods")));
        QSettings().setValue(QStringLiteral("trustedFolders"), QStringList{QStringLiteral("/gone/for/good")});
        TrustedFolders::remove(QStringLiteral("/gone/for/good"));
        QVERIFY(TrustedFolders::all().isEmpty());
    }

    void theStatusLineCountsAndWaits() {
        SessionFixture o;
        RunStatus status(o.session);
        QSignalSpy changed(&status, &RunStatus::changed);
        const auto text = [&] { return changed.isEmpty() ? QString() : changed.last()[0].toString(); };
        const auto matches = [&](const char* pattern) {
            const QString whole = QRegularExpression::anchoredPattern(QString::fromUtf8(pattern));
            return QRegularExpression(whole).match(text()).hasMatch();
        };
        QVERIFY(o.open(kThings + "Duration = 0.05\n"));
        o.session.step();
        QCOMPARE(text(), QStringLiteral("2 robots, 1 object")); // while it is built
        EVENTUALLY_EQUAL(o.session.state(), RunState::Paused);
        QVERIFY2(matches("2 robots, 1 object  •  [0-9]+ contacts  •  step [0-9]+(\\.[0-9]{2})? ms"), qPrintable(text()));
        QCOMPARE(changed.last()[1].toString(), QString());
        QVERIFY(o.document.structure().setValues(QStringLiteral("Set"), {{"Duration", "0.08"}}).ok());
        QVERIFY2(matches("2 robots, 1 object  •  .* ms  •  edits wait for Reset"), qPrintable(text()));
        o.document.edits().undo();
        QVERIFY2(!text().contains(QStringLiteral("wait")), qPrintable(text()));
        o.session.run();
        EVENTUALLY_EQUAL(o.session.state(), RunState::Ended);
        QVERIFY(o.document.structure().setValues(QStringLiteral("Set"), {{"Duration", "0.08"}}).ok());
        QVERIFY2(matches("2 robots, 1 object  •  .* ms  •  edits wait: F5 begins again with them"), qPrintable(text()));
        o.session.reset();
        QCOMPARE(text(), QString());
        QVERIFY(o.open(kStandingRobot));
        o.session.step();
        QCOMPARE(text(), QStringLiteral("1 robot"));
    }

    /// A slot of a message may reset the run; then nothing of it is shown any more.
    void aResetByAMessageEndsIt() {
        SessionFixture o;
        QVERIFY(o.open(QByteArray(kStandingRobot)
                           .replace("#import arenas", "#loadModule controllers/linear_motion\n#import arenas")
                           .replace("HPR=0,0,0 }", "HPR=0,0,0 LinearMotion brain { Distance=0.001 Speed=1 } }")));
        RunSession& s = o.session;
        int resets = 0;
        connect(&s.messages(), &RunMessages::consoleLines, &s, [&](const std::vector<LiveLine>& lines) {
            if (std::ranges::any_of(lines, [](const LiveLine& line) { return line.text.starts_with("done"); }))
                ++resets, s.reset();
        });
        s.setSpeed(0);
        s.run();
        EVENTUALLY_EQUAL(resets, 1);
        for (int i = 0; i < 20; ++i) QCoreApplication::processEvents();
        QCOMPARE(s.state(), RunState::Start);
        QVERIFY(!s.results().poses && !s.results().snapshot && !s.results().layout && !s.results().experiment);
    }

    void editsOfViewsWaitOnlyWhereALogShowsThem_data() {
        QTest::addColumn<std::string>("from");
        QTest::addColumn<std::string>("to");
        QTest::addColumn<QStringList>("waiting");
        QTest::newRow("a View that only the window shows")
            << std::string("Eye=1,1,1") << std::string("Eye=1,1,2") << QStringList{};
        QTest::newRow("a View of a log") << std::string("Eye=2,2,2") << std::string("Eye=2,2,3")
                                         << QStringList{QStringLiteral("corner2.Eye")};
        QTest::newRow("a new one") << std::string("View corner2") << std::string("View more { Eye=0,0,1 }\nView corner2")
                                   << QStringList{};
        QTest::newRow("another object of such a name")
            << std::string("Pos=0,0,0 HPR") << std::string("Pos=0,0,1 HPR") << QStringList{QStringLiteral("robot0.Pos")};
    }
    void editsOfViewsWaitOnlyWhereALogShowsThem() {
        QFETCH(std::string, from);
        QFETCH(std::string, to);
        QFETCH(QStringList, waiting);
        SessionFixture o;
        std::string text = kStandingRobot.toStdString() + "View corner { Eye=1,1,1 Target=0,0,0 }\n"
                                                          "View corner2 { Eye=2,2,2 Target=0,0,0 }\n"
                                                          "FrameLog film { View=corner2 Interval=1 }\n";
        QVERIFY(o.open(QByteArray::fromStdString(text)));
        const auto built = o.document.loaded();
        text.replace(text.find(from), from.size(), to);
        QVERIFY(o.document.edits().replaceText(u"Type"_qs, o.document.path(), text).ok());
        QVERIFY(!o.document.loaded()->diagnostics.hasErrors());
        RunComparison comparison;
        comparison.begin(built);
        QStringList waits;
        for (const std::string& path : comparison.follow(ChangeSet(built, o.document.loaded()), *built->experiment).waiting)
            waits << QString::fromStdString(path);
        QCOMPARE(waits, waiting);
    }

    void aModuleOfTwoKindsIsListedWithBoth() {
        SessionFixture o;
        QVERIFY(o.open("#loadModule controllers/network_navigator\n#loadModule controllers/none\n" + kStandingRobot));
        const auto modules = ControllerCommands(o.document, o.session).modules();
        QCOMPARE(modules.size(), 2u);
        QCOMPARE(modules[0].kinds, (std::vector<std::string>{"BearingSweep", "NetworkNavigator"}));
        QVERIFY(modules[0].trouble.isEmpty() && modules[0].usedBy.empty() &&
                modules[0].library.ends_with("libnetwork_navigator.so"));
        QVERIFY(modules[1].kinds.empty() && modules[1].library.empty() && !modules[1].trouble.isEmpty());
    }

    void linesOfTheConsole() {
        ConsoleModel model;
        model.append({{1.005, "robot0/brain", TRUNDLE_INFO, "plain\n\nlast\n\n"},
                      {2.5, "", TRUNDLE_WARNING, "careful"},
                      {3, "robot1", TRUNDLE_ERROR, std::string(4001, 'x')},
                      {4, "robot10", TRUNDLE_INFO, std::string(4000, 'y')}},
                     0);
        const auto at = [&](int row, int column, int role = Qt::DisplayRole) {
            return model.data(model.index(row, column), role);
        };
        QCOMPARE(model.rowCount(), 6);
        QCOMPARE(at(0, ConsoleModel::Text).toString() + at(1, ConsoleModel::Text).toString() +
                     at(2, ConsoleModel::Text).toString(),
                 QStringLiteral("plainlast"));
        QCOMPARE(at(2, ConsoleModel::Who).toString(), QStringLiteral("robot0/brain"));
        QCOMPARE(at(3, ConsoleModel::Time).toString(), QStringLiteral("2.50"));
        QCOMPARE(at(4, ConsoleModel::Text).toString(), QString(4000, u'x') + QStringLiteral(" …"));
        QCOMPARE(at(5, ConsoleModel::Text).toString(), QString(4000, u'y'));
        QCOMPARE(at(0, ConsoleModel::Text, Qt::ToolTipRole).toString(), QStringLiteral("plain"));
        QVERIFY(!at(0, ConsoleModel::Who, Qt::ToolTipRole).isValid());
        QVERIFY(!at(0, ConsoleModel::Text, Qt::ForegroundRole).isValid());
        QCOMPARE(at(3, ConsoleModel::Text, Qt::ForegroundRole).value<QColor>(), ink(Ink::Warning));
        QCOMPARE(at(4, ConsoleModel::Text, Qt::ForegroundRole).value<QColor>(), ink(Ink::Error));
        for (const int row : {0, 3, 4})
            for (const int column : {ConsoleModel::Time, ConsoleModel::Who})
                QCOMPARE(at(row, column, Qt::ForegroundRole).value<QColor>(), ink(Ink::Faint));
        QCOMPARE(at(0, ConsoleModel::Time, Qt::TextAlignmentRole).toInt(), int(Qt::AlignRight | Qt::AlignVCenter));
        QVERIFY(!at(0, ConsoleModel::Text, Qt::TextAlignmentRole).isValid());
        QStringList headers;
        for (int i = 0; i < model.columnCount(); ++i) headers << model.headerData(i, Qt::Horizontal, Qt::DisplayRole).toString();
        QCOMPARE(headers, (QStringList{QStringLiteral("Time, s"), QStringLiteral("Robot"), QStringLiteral("Text")}));
        QVERIFY(!model.headerData(0, Qt::Vertical, Qt::DisplayRole).isValid());
        QCOMPARE(model.headerData(0, Qt::Horizontal, Qt::TextAlignmentRole).toInt(), int(Qt::AlignRight | Qt::AlignVCenter));
        QCOMPARE(model.headerData(1, Qt::Horizontal, Qt::TextAlignmentRole).toInt(), int(Qt::AlignLeft | Qt::AlignVCenter));
        QCOMPARE(model.copyText({model.index(3, 0), model.index(0, 2)}),
                 QStringLiteral("[1.00 robot0/brain] plain\n[2.50] careful"));

        for (const auto& [robot, rows] : {std::pair{"robot0", 3}, {"robot1", 1}, {"robot10", 1}, {"", 6}}) {
            model.setFilter(QLatin1String(robot), {});
            QCOMPARE(model.rowCount(), rows);
        }
        model.setFilter(ConsoleModel::kRunItself, {});
        QCOMPARE(model.rowCount(), 1);
        model.setFilter({}, QStringLiteral("BRAIN")); // also in the name
        QCOMPARE(model.rowCount(), 3);
        model.setFilter(QStringLiteral("robot0"), QStringLiteral("Last"));
        QCOMPARE(model.rowCount(), 1);
    }
};

QTEST_MAIN(RunTextsTest)
#include "run_texts_test.moc"
