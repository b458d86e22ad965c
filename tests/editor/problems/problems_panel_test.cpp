// The Problems panel: diagnostics of the text, of the model check and of runs.
#include <filesystem>
#include <fstream>

#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <QTreeView>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/problems/model_checker.h"
#include "editor/problems/problems_model.h"
#include "editor/problems/problems_panel.h"
#include "editor/widgets/apply_theme.h"
#include "eventually.h"

using namespace trundle;

namespace {

struct ProblemsFixture {
    QTemporaryDir folder;
    std::unique_ptr<Application> application = makeApplication();
    Document document{*application};
    Selection selection;
    ProblemsPanel panel{document, selection};

    ProblemsFixture() {
        panel.resize(760, 220);
        panel.show();
    }
    bool open(const std::string& text) {
        const std::filesystem::path path = std::filesystem::path(folder.path().toStdString()) / "configs" / "main.sim";
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << text;
        return document.opening().open(path.string()).ok();
    }
    QTreeView& view() const { return *panel.findChild<QTreeView*>(QStringLiteral("problems")); }
    QAbstractItemModel& model() const { return *view().model(); }
    QLabel& none() const { return *panel.findChild<QLabel*>(QStringLiteral("noProblems")); }
    QToolButton& button(const char* name) const { return *panel.findChild<QToolButton*>(QLatin1String(name)); }
    QStringList messages() const {
        QStringList all;
        for (int i = 0; i < model().rowCount(); ++i) all << model().index(i, 0).data().toString();
        return all;
    }
    void click(const QModelIndex& index) const {
        view().scrollTo(index);
        QTest::mouseClick(view().viewport(), Qt::LeftButton, {}, view().visualRect(index).center());
    }
    std::string text() const { return *document.texts().text(document.texts().files()[0]); }
    void picture(const char* name) {
        const QString to = qEnvironmentVariable("TRUNDLE_PICTURES");
        QApplication::processEvents();
        if (!to.isEmpty()) panel.grab().save(to + QLatin1Char('/') + QLatin1String(name) + QStringLiteral(".png"));
    }
};

const std::string kGood = R"(RobotConfig Crate { Body box { Box hull { Size=1,1,1 Mass=1 Material=default Surface=default } } }
Robot crate { Config=Crate Pos=0,0,1 }
)";
const std::string kBad = R"(Tikc = 0.01
RobotConfig Crate { Body box { Box hull { Size=1,1,-1 Mass=1 Material=default Surface=default } } }
Robot crate { Config=Crat Pos=0,0,1 }
Robot crate { Config=Crate Pos=0,0,1 }
)";

const std::string kInWall = R"(Tick = 0.01 Duration = 1
StaticConfig Floor { Plane ground { Material=default Surface=default } }
Static floor { Config=Floor }
StaticConfig Wall { Box side { Size=0.2,4,1 Material=default Surface=default } }
Static wall { Config=Wall Pos=1,0,0.5 }
RobotConfig Crate { Body b { Box hull { Size=0.2,0.2,0.2 Mass=1 Material=default Surface=default } } }
Robot crate { Config=Crate Pos=0.85,0,0.1 }
)";

/// Counts finished model checks.
void countChecks(ProblemsFixture& fixture, int& count) {
    QObject::connect(fixture.panel.findChild<ModelChecker*>(), &ModelChecker::checked, &fixture.panel, [&count] { ++count; });
}

} // namespace

class ProblemsPanelTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { applyTheme(*qApp, ThemeKind::Light); }

    void emptyStates() {
        ProblemsFixture fixture;
        QVERIFY(fixture.none().isVisible());
        QVERIFY(fixture.open(kGood));
        QCOMPARE(fixture.messages(), QStringList());
        QCOMPARE(fixture.none().text(), QStringLiteral("No problems"));
        QVERIFY(fixture.none().isVisible());
        fixture.picture("no_problems");
    }

    void theListAndItsCounts() {
        ProblemsFixture fixture;
        QSignalSpy counts(&fixture.panel, &ProblemsPanel::countsChanged);
        QVERIFY(fixture.open(kBad));
        QCOMPARE(counts.back().at(0).toInt(), fixture.panel.errors());
        QVERIFY(fixture.panel.errors() >= 4);
        QVERIFY(!fixture.none().isVisible());
        QVERIFY(fixture.messages().at(0).contains(QStringLiteral("Tikc")));
        QCOMPARE(fixture.model().index(0, ProblemsModel::CodeColumn).data().toString(), QStringLiteral("E201"));
        QCOMPARE(fixture.model().index(0, ProblemsModel::Place).data().toString(), QStringLiteral("main.sim:1:1"));
        fixture.view().expandAll();
        fixture.picture("problems");
        fixture.button("showErrors").setChecked(false);
        QCOMPARE(fixture.model().rowCount(), fixture.panel.warnings());
        fixture.button("showErrors").setChecked(true);
        auto* filter = fixture.panel.findChild<QLineEdit*>(QStringLiteral("problemFilter"));
        filter->setText(QStringLiteral("tikc"));
        QCOMPARE(fixture.model().rowCount(), 1);
        filter->setText(QStringLiteral("no such words"));
        QVERIFY(fixture.none().isVisible());
        QVERIFY(fixture.none().text().contains(QStringLiteral("filter")));
    }

    /// A message is elided only where the place has no more than its least width; the place is whole in its tooltip.
    void messagesHaveTheRoom() {
        for (const int font : {13, 17}) {
            applyTheme(*qApp, ThemeKind::Light, {font, font});
            ProblemsFixture fixture;
            QVERIFY(fixture.open(kBad));
            for (const int width : {420, 760, 1400}) {
                fixture.panel.resize(width, 220);
                QCoreApplication::processEvents();
                QTreeView& view = fixture.view();
                const int message = view.columnWidth(ProblemsModel::Message), place = view.columnWidth(ProblemsModel::Place);
                const QFontMetrics metrics = view.fontMetrics();
                int longest = 0;
                for (const QString& text : fixture.messages()) longest = std::max(longest, metrics.horizontalAdvance(text));
                const int least = metrics.averageCharWidth() * 16 + 16;
                QVERIFY2(message >= longest || place <= least,
                         qPrintable(QStringLiteral("%1: %2 %3").arg(width).arg(message).arg(place)));
                QVERIFY(view.columnWidth(ProblemsModel::CodeColumn) >= metrics.horizontalAdvance(QStringLiteral("E201")));
            }
            const QModelIndex first = fixture.model().index(0, ProblemsModel::Place);
            QCOMPARE(first.data(Qt::ToolTipRole).toString(), first.data().toString());
            fixture.view().header()->resizeSection(ProblemsModel::Message, 200); // one's own widths stay
            fixture.panel.resize(900, 220);
            QCoreApplication::processEvents();
            QCOMPARE(fixture.view().columnWidth(ProblemsModel::Message), 200);
        }
        applyTheme(*qApp, ThemeKind::Light);
    }

    void clickRevealsTextAndObject() {
        ProblemsFixture fixture;
        QVERIFY(fixture.open(kBad));
        std::vector<std::pair<std::string, SourceRange>> jumps;
        connect(&fixture.panel, &ProblemsPanel::jumpTo, &fixture.panel,
                [&](const std::string& file, const SourceRange& range) { jumps.emplace_back(file, range); });
        for (int i = 0; i < fixture.model().rowCount(); ++i) {
            if (!fixture.messages().at(i).contains(QStringLiteral("Crat,"))) continue;
            fixture.click(fixture.model().index(i, 0));
        }
        QCOMPARE(jumps.size(), 1u);
        QCOMPARE(jumps[0].first, fixture.document.texts().files()[0]);
        QCOMPARE(fixture.text().substr(jumps[0].second.range.begin, jumps[0].second.range.size()), std::string("Crat"));
        QCOMPARE(fixture.selection.current(), std::string("crate"));
        // A note below a problem goes to its own source range.
        for (int i = 0; i < fixture.model().rowCount(); ++i) {
            const QModelIndex top = fixture.model().index(i, 0);
            if (fixture.model().rowCount(top) == 0 ||
                !fixture.model().index(0, 2, top).data().toString().startsWith(QStringLiteral("main.sim:3")))
                continue;
            fixture.view().expand(top);
            fixture.click(fixture.model().index(0, 0, top));
            QCOMPARE(jumps.size(), 2u);
            QVERIFY(jumps[1].second != jumps[0].second);
            return;
        }
        QFAIL("the second crate names the first");
    }

    void fixesAreEdits() {
        ProblemsFixture fixture;
        QVERIFY(fixture.open(kBad));
        const std::string before = fixture.text();
        fixture.view().setCurrentIndex(fixture.model().index(0, 0));
        QVERIFY(fixture.button("applyFix").isEnabled());
        QTest::keyClick(&fixture.view(), Qt::Key_Return, Qt::AltModifier);
        QCOMPARE(fixture.text(), "Tick" + before.substr(4));
        QVERIFY(fixture.document.edits().history().entries().back().name.startsWith(QStringLiteral("Fix: ")));
        QVERIFY(!fixture.messages().at(0).contains(QStringLiteral("Tikc")));
        QVERIFY(fixture.view().currentIndex().isValid()); // the next problem is selected
        fixture.document.edits().undo();
        QCOMPARE(fixture.text(), before);
        // The same for the rows below.
        const QModelIndex top = fixture.model().index(0, 0);
        fixture.view().expand(top);
        QModelIndex fix;
        for (int i = 0; i < fixture.model().rowCount(top); ++i)
            if (fixture.model().index(i, 0, top).data().toString().startsWith(QStringLiteral("Fix")))
                fix = fixture.model().index(i, 0, top);
        QVERIFY(fix.isValid());
        const int fixRow = fix.row();
        fixture.view().setCurrentIndex(fix);
        QTest::mouseClick(&fixture.button("applyFix"), Qt::LeftButton);
        QCOMPARE(fixture.text(), "Tick" + before.substr(4));
        fixture.document.edits().undo();
        fixture.view().expand(fixture.model().index(0, 0));
        fixture.click(fixture.model().index(fixRow, 0, fixture.model().index(0, 0)));
        QCOMPARE(fixture.text(), "Tick" + before.substr(4));
    }

    /// After a fix the problem that followed is selected, after that of the last one the one before.
    void theNextProblemIsSelected() {
        ProblemsFixture fixture;
        QVERIFY(fixture.open("Tikc = 0.01\nDuratoin = 1\nGravty = 0,0,-9\nSede = 3\n"));
        QCOMPARE(fixture.model().rowCount(), 4);
        for (const auto& [row, next] : {std::pair(1, "Gravty"), {2, "Gravty"}, {0, "Gravty"}}) {
            const QModelIndex top = fixture.model().index(row, 0);
            for (int i = 0; i < fixture.model().rowCount(top); ++i) {
                const QModelIndex child = fixture.model().index(i, 0, top);
                const bool isFix = child.data().toString().startsWith(QStringLiteral("Fix"));
                QCOMPARE(!child.data(Qt::DecorationRole).isNull(), isFix);
            }
            fixture.view().setCurrentIndex(top);
            QTest::mouseClick(&fixture.button("applyFix"), Qt::LeftButton);
            QVERIFY2(fixture.view().currentIndex().data().toString().contains(QLatin1String(next)),
                     qPrintable(fixture.view().currentIndex().data().toString()));
        }
        QCOMPARE(fixture.model().rowCount(), 1);
    }

    void typingKeepsProblemList() {
        ProblemsFixture fixture;
        QVERIFY(fixture.open(kBad));
        fixture.view().expand(fixture.model().index(1, 0));
        QSignalSpy resets(&fixture.model(), &QAbstractItemModel::modelReset);
        QVERIFY(fixture.document.edits()
                    .replaceText(QStringLiteral("Typing"), fixture.document.texts().files()[0], "// one line more\n" + kBad)
                    .ok());
        QCOMPARE(resets.size(), 0);
        QVERIFY(fixture.view().isExpanded(fixture.model().index(1, 0)));
        QCOMPARE(fixture.model().index(0, ProblemsModel::Place).data().toString(), QStringLiteral("main.sim:2:1"));
        QVERIFY(fixture.document.edits().replaceText(QStringLiteral("Typing"), fixture.document.texts().files()[0], kGood).ok());
        QCOMPARE(resets.size(), 1);
        QVERIFY(fixture.none().isVisible());
    }

    void aRunsFailureIsAProblem() {
        ProblemsFixture fixture;
        QVERIFY(fixture.open(kGood));
        Diagnostic blown;
        blown.code = Code::BlowUp;
        blown.message = "crate blew up at t = 3.2 s";
        blown.range = {0, {static_cast<std::uint32_t>(kGood.find("crate")), static_cast<std::uint32_t>(kGood.find("crate")) + 5}};
        fixture.panel.setRunProblems({blown}, fixture.document.loaded());
        QCOMPARE(fixture.messages(), QStringList(QStringLiteral("crate blew up at t = 3.2 s")));
        QCOMPARE(fixture.panel.errors(), 1);
        fixture.click(fixture.model().index(0, 0));
        QCOMPARE(fixture.selection.current(), std::string("crate"));
        Diagnostic nowhere;
        nowhere.message = "the log folder is gone";
        fixture.panel.setRunProblems({blown, nowhere}, fixture.document.loaded());
        fixture.click(fixture.model().index(1, 0)); // without a source range: nothing happens
        QVERIFY(fixture.document.edits()
                    .replaceText(QStringLiteral("Typing"), fixture.document.texts().files()[0], "Tick = 0.01\n")
                    .ok());
        QCOMPARE(fixture.panel.errors(), 2);
        fixture.click(fixture.model().index(0, 0)); // its source range belongs to an older text
        fixture.panel.clearRunProblems();
        QCOMPARE(fixture.panel.errors(), 0);
    }

    void listsModelCheckProblems() {
        ProblemsFixture fixture;
        QVERIFY(fixture.open(kInWall));
        QCOMPARE(fixture.messages(), QStringList()); // opening does not wait for the check
        EVENTUALLY_EQUAL(fixture.model().rowCount(), 1);
        QVERIFY2(fixture.messages().at(0).contains(QStringLiteral("starts inside wall")), qPrintable(fixture.messages().at(0)));
        QCOMPARE(fixture.model().index(0, ProblemsModel::Place).data().toString(), QStringLiteral("main.sim:7:7"));
        QCOMPARE(fixture.panel.warnings(), 1);
        fixture.view().expandAll();
        fixture.picture("model_check");
        fixture.click(fixture.model().index(0, 0));
        QCOMPARE(fixture.selection.current(), std::string("crate"));

        int checks = 0;
        countChecks(fixture, checks);
        QVERIFY(fixture.button("applyFix").isEnabled());
        QTest::mouseClick(&fixture.button("applyFix"), Qt::LeftButton);
        QVERIFY(fixture.text() != kInWall);
        EVENTUALLY_EQUAL(checks, 1);
        QCOMPARE(fixture.messages(), QStringList());
        fixture.document.edits().undo();
        QCOMPARE(fixture.text(), kInWall);
        EVENTUALLY_EQUAL(fixture.model().rowCount(), 1);
    }

    /// What a run would refuse without running code of a module.
    void listsLogsThatARunRefuses() {
        ProblemsFixture fixture;
        QVERIFY(fixture.open(kInWall + "PoseLog path { Robot=crane }\nSignalLog all { Signals=\"crate/speed\" }\n"));
        EVENTUALLY_EQUAL(fixture.model().rowCount(), 3);
        QVERIFY2(fixture.messages().at(1).contains(QStringLiteral("no robot is called 'crane'")),
                 qPrintable(fixture.messages()[1]));
        QCOMPARE(fixture.model().index(1, ProblemsModel::Place).data().toString(), QStringLiteral("main.sim:8:22"));
        QVERIFY2(fixture.messages().at(2).contains(QStringLiteral("crate/speed")), qPrintable(fixture.messages()[2]));
        QCOMPARE(fixture.panel.errors(), 2);
    }

    /// A run that is refused because of problems that the check has reported adds no problem.
    void reportsRefusedRunOnce() {
        ProblemsFixture fixture;
        std::string text = kGood;
        QVERIFY(fixture.open(text));
        Diagnostic found;
        found.code = Code::DeviceSetup;
        found.message = "one motor";
        auto* model = qobject_cast<ProblemsModel*>(&fixture.model());
        model->setModelProblems({found}, fixture.document.loaded());
        Diagnostic refused = found;
        refused.message = "the same motor";
        fixture.panel.setRunProblems({refused}, fixture.document.loaded());
        QCOMPARE(fixture.messages(), QStringList{QStringLiteral("one motor")});
        Diagnostic other = refused;
        other.code = Code::ControllerFailed; // another reason
        fixture.panel.setRunProblems({refused, other}, fixture.document.loaded());
        QCOMPARE(fixture.model().rowCount(), 2);
    }

    void theModelCheckFollowsTheText() {
        ProblemsFixture fixture;
        QVERIFY(fixture.open(kInWall));
        EVENTUALLY_EQUAL(fixture.model().rowCount(), 1);
        int checks = 0;
        countChecks(fixture, checks);
        const std::string file = fixture.document.texts().files()[0];
        QVERIFY(fixture.document.edits().replaceText(QStringLiteral("Typing"), file, kInWall + "// more\n").ok());
        QCOMPARE(fixture.messages(), QStringList()); // problems of the old text are removed at once
        EVENTUALLY_EQUAL(checks, 1);
        QCOMPARE(fixture.model().rowCount(), 1);
        QVERIFY(
            fixture.document.edits().replaceText(QStringLiteral("Typing"), file, kInWall + "Robot other { Config=Crat }\n").ok());
        EVENTUALLY_EQUAL(checks, 2);
        QVERIFY(fixture.panel.errors() > 0); // errors come first; a text with errors is not checked further
        for (const QString& message : fixture.messages()) QVERIFY(!message.contains(QStringLiteral("starts inside")));
    }

    void robotsAreSetUpInAnotherProcess_data() {
        QTest::addColumn<QString>("modules");
        QTest::addColumn<QByteArray>("loading");
        QTest::addColumn<QByteArray>("controller");
        QTest::addColumn<QString>("said");
        QTest::addColumn<bool>("isAtController");
        const QString zoo = QStringLiteral(TRUNDLE_BINARY_DIR "/tests/modules/zoo");
        QTest::newRow("a port that the robot lacks") << QString() << QByteArray("controllers/linear_motion")
                                                     << QByteArray("LinearMotion brain { }") << "DifferentialDrive" << true;
        QTest::newRow("a crash") << zoo << QByteArray("zoo") << QByteArray("Zoo brain { Action=segv Phase=setup }")
                                 << "crashed in setup" << false;
        QTest::newRow("a loop") << zoo << QByteArray("zoo") << QByteArray("Zoo brain { Action=loop Phase=setup }")
                                << "took more than" << false;
    }
    void robotsAreSetUpInAnotherProcess() {
        QFETCH(QString, modules);
        QFETCH(QByteArray, loading);
        QFETCH(QByteArray, controller);
        QFETCH(QString, said);
        QFETCH(bool, isAtController);
        ProblemsFixture fixture;
        OpenOptions options;
        if (!modules.isEmpty()) options.modules = {modules.toStdString()};
        fixture.document.setOptions(options);
        fixture.panel.checkRobotsWith(TRUNDLE_BINARY_DIR "/bin/trundle-cli", 2);
        const QByteArray text = "#import robots/simple_robot.sim\n#import arenas/open_floor.sim\n#loadModule " + loading +
                                "\nTick = 0.01 Duration = 1\nStatic floor { Config=OpenFloor }\n"
                                "RobotConfig Crate { Body b { Box hull { Size=1,1,1 Pos=0,0,0.5 Mass=1 Material=default "
                                "Surface=default } } }\nRobot crate { Config=Crate Pos=9,9,0 }\n";
        QVERIFY(fixture.open(text.toStdString()));
        QCOMPARE(fixture.panel.errors(), 0);
        // The unsaved text is checked.
        QByteArray changed = text;
        changed.replace("{ Config=Crate", (isAtController ? "{ Config=Crate " : "{ Config=SimpleRobot ") + controller);
        const std::string file = fixture.document.texts().files()[0];
        QVERIFY(fixture.document.edits().replaceText(QStringLiteral("Typing"), file, changed.toStdString()).ok());
        QTRY_COMPARE_WITH_TIMEOUT(fixture.model().rowCount(), 1, 30'000);
        QVERIFY2(fixture.messages()[0].contains(said), qPrintable(fixture.messages()[0]));
        const SourceRange place = dynamic_cast<ProblemsModel&>(fixture.model()).placeAt(fixture.model().index(0, 0));
        QCOMPARE(place.known(), isAtController);
        if (isAtController) QCOMPARE(fixture.document.loaded()->sources.slice(place), std::string_view("brain"));
        // A later text without the mistake removes it.
        QVERIFY(fixture.document.edits().replaceText(QStringLiteral("Typing"), file, text.toStdString()).ok());
        QCOMPARE(fixture.model().rowCount(), 0);
    }

    /// What only a trial on a plain floor finds comes a moment after the rest.
    void robotsAreTried() {
        ProblemsFixture fixture;
        QVERIFY(fixture.open("#import robots/simple_robot.sim\n#import arenas/open_floor.sim\nStatic floor { Config=OpenFloor }\n"
                             "Robot r { Config=SimpleRobot leftAxle.Friction=100 rightAxle.Friction=100 }\n"));
        QTRY_COMPARE_WITH_TIMEOUT(fixture.model().rowCount(), 1, 30'000);
        QVERIFY2(fixture.messages()[0].contains(QStringLiteral("does not move the robot")), qPrintable(fixture.messages()[0]));
    }

    void thePanelMayGoWhileItChecks() {
        for (int i = 0; i < 3; ++i) {
            ProblemsFixture fixture;
            QVERIFY(fixture.open(kInWall));
            auto* checker = fixture.panel.findChild<ModelChecker*>();
            QVERIFY(QMetaObject::invokeMethod(checker->findChild<QTimer*>(), "timeout")); // starts the check at once
        }
    }

    void tenThousand() {
        ProblemsFixture fixture;
        std::vector<Diagnostic> many;
        for (int i = 0; i < 10000; ++i) {
            Diagnostic d;
            d.severity = i % 3 == 0 ? Severity::Warning : Severity::Error;
            d.message = "problem " + std::to_string(i);
            d.notes.push_back({"see here", {0, {0, 1}}});
            many.push_back(d);
        }
        QVERIFY(fixture.open(kGood));
        fixture.panel.setRunProblems(many, fixture.document.loaded());
        QCOMPARE(fixture.model().rowCount(), 10000);
        QCOMPARE(fixture.panel.errors(), 6666);
        fixture.view().scrollToBottom();
        fixture.panel.findChild<QLineEdit*>(QStringLiteral("problemFilter"))->setText(QStringLiteral("problem 77"));
        QCOMPARE(fixture.model().rowCount(), 111);
        fixture.panel.goTo(1);
        QCOMPARE(fixture.view().currentIndex().row(), 0);
        fixture.panel.goTo(-1);
        QCOMPARE(fixture.view().currentIndex().row(), 110);
        fixture.panel.goTo(1);
        QCOMPARE(fixture.view().currentIndex().row(), 0);
    }
};

QTEST_MAIN(ProblemsPanelTest)
#include "problems_panel_test.moc"
