#include <filesystem>
#include <fstream>

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
#include "editor/widgets/theme.h"

using namespace trundle;

namespace {

struct ProblemsDesk {
    QTemporaryDir folder;
    std::unique_ptr<Parts> parts = makeParts();
    Document document{*parts};
    Selection selection;
    ProblemsPanel panel{document, selection};

    ProblemsDesk() {
        panel.resize(760, 220);
        panel.show();
    }
    bool open(const std::string& text) {
        const std::filesystem::path path = std::filesystem::path(folder.path().toStdString()) / "configs" / "main.sim";
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << text;
        return document.open(path.string()).ok();
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
    std::string text() const { return *document.text(document.files()[0]); }
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

/// How often the model check ended.
void countChecks(ProblemsDesk& desk, int& count) {
    QObject::connect(desk.panel.findChild<ModelChecker*>(), &ModelChecker::checked, &desk.panel, [&count] { ++count; });
}

} // namespace

class ProblemsPanelTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { applyTheme(*qApp, ThemeKind::Light); }

    void emptyStates() {
        ProblemsDesk desk;
        QVERIFY(desk.none().isVisible());
        QVERIFY(desk.open(kGood));
        QCOMPARE(desk.messages(), QStringList());
        QCOMPARE(desk.none().text(), QStringLiteral("No problems"));
        QVERIFY(desk.none().isVisible());
        desk.picture("no_problems");
    }

    void theListAndItsCounts() {
        ProblemsDesk desk;
        QSignalSpy counts(&desk.panel, &ProblemsPanel::countsChanged);
        QVERIFY(desk.open(kBad));
        QCOMPARE(counts.back().at(0).toInt(), desk.panel.errors());
        QVERIFY(desk.panel.errors() >= 4);
        QVERIFY(!desk.none().isVisible());
        QVERIFY(desk.messages().at(0).contains(QStringLiteral("Tikc")));
        QCOMPARE(desk.model().index(0, ProblemsModel::CodeColumn).data().toString(), QStringLiteral("E201"));
        QCOMPARE(desk.model().index(0, ProblemsModel::Place).data().toString(), QStringLiteral("main.sim:1:1"));
        desk.view().expandAll();
        desk.picture("problems");
        desk.button("showErrors").setChecked(false);
        QCOMPARE(desk.model().rowCount(), desk.panel.warnings());
        desk.button("showErrors").setChecked(true);
        auto* filter = desk.panel.findChild<QLineEdit*>(QStringLiteral("problemFilter"));
        filter->setText(QStringLiteral("tikc"));
        QCOMPARE(desk.model().rowCount(), 1);
        filter->setText(QStringLiteral("no such words"));
        QVERIFY(desk.none().isVisible());
        QVERIFY(desk.none().text().contains(QStringLiteral("filter")));
    }

    void aClickGoesToTextAndObject() {
        ProblemsDesk desk;
        QVERIFY(desk.open(kBad));
        std::vector<std::pair<std::string, SourceRange>> jumps;
        connect(&desk.panel, &ProblemsPanel::jumpTo, &desk.panel,
                [&](const std::string& file, const SourceRange& range) { jumps.emplace_back(file, range); });
        for (int i = 0; i < desk.model().rowCount(); ++i) {
            if (!desk.messages().at(i).contains(QStringLiteral("Crat,"))) continue;
            desk.click(desk.model().index(i, 0));
        }
        QCOMPARE(jumps.size(), 1u);
        QCOMPARE(jumps[0].first, desk.document.files()[0]);
        QCOMPARE(desk.text().substr(jumps[0].second.range.begin, jumps[0].second.range.size()), std::string("Crat"));
        QCOMPARE(desk.selection.current(), std::string("crate"));
        // a note below goes to its own place
        for (int i = 0; i < desk.model().rowCount(); ++i) {
            const QModelIndex top = desk.model().index(i, 0);
            if (desk.model().rowCount(top) == 0 ||
                !desk.model().index(0, 2, top).data().toString().startsWith(QStringLiteral("main.sim:3")))
                continue;
            desk.view().expand(top);
            desk.click(desk.model().index(0, 0, top));
            QCOMPARE(jumps.size(), 2u);
            QVERIFY(jumps[1].second != jumps[0].second);
            return;
        }
        QFAIL("the second crate names the first");
    }

    void fixesAreEdits() {
        ProblemsDesk desk;
        QVERIFY(desk.open(kBad));
        const std::string before = desk.text();
        desk.view().setCurrentIndex(desk.model().index(0, 0));
        QVERIFY(desk.button("applyFix").isEnabled());
        QTest::keyClick(&desk.view(), Qt::Key_Return, Qt::AltModifier);
        QCOMPARE(desk.text(), "Tick" + before.substr(4));
        QVERIFY(desk.document.history().entries().back().name.startsWith(QStringLiteral("Fix: ")));
        QVERIFY(!desk.messages().at(0).contains(QStringLiteral("Tikc")));
        QVERIFY(desk.view().currentIndex().isValid()); // the next one is at hand
        desk.document.undo();
        QCOMPARE(desk.text(), before);
        // the same below the row
        const QModelIndex top = desk.model().index(0, 0);
        desk.view().expand(top);
        QModelIndex fix;
        for (int i = 0; i < desk.model().rowCount(top); ++i)
            if (desk.model().index(i, 0, top).data().toString().startsWith(QStringLiteral("Fix")))
                fix = desk.model().index(i, 0, top);
        QVERIFY(fix.isValid());
        desk.view().setCurrentIndex(fix);
        QTest::mouseClick(&desk.button("applyFix"), Qt::LeftButton);
        QCOMPARE(desk.text(), "Tick" + before.substr(4));
    }

    void typingElsewhereKeepsTheListAsItIs() {
        ProblemsDesk desk;
        QVERIFY(desk.open(kBad));
        desk.view().expand(desk.model().index(1, 0));
        QSignalSpy resets(&desk.model(), &QAbstractItemModel::modelReset);
        QVERIFY(desk.document.replaceText(QStringLiteral("Typing"), desk.document.files()[0], "// one line more\n" + kBad).ok());
        QCOMPARE(resets.size(), 0);
        QVERIFY(desk.view().isExpanded(desk.model().index(1, 0)));
        QCOMPARE(desk.model().index(0, ProblemsModel::Place).data().toString(), QStringLiteral("main.sim:2:1"));
        QVERIFY(desk.document.replaceText(QStringLiteral("Typing"), desk.document.files()[0], kGood).ok());
        QCOMPARE(resets.size(), 1);
        QVERIFY(desk.none().isVisible());
    }

    void aRunsFailureIsAProblem() {
        ProblemsDesk desk;
        QVERIFY(desk.open(kGood));
        Diagnostic blown;
        blown.code = Code::BlowUp;
        blown.message = "crate blew up at t = 3.2 s";
        blown.range = {0, {static_cast<std::uint32_t>(kGood.find("crate")), static_cast<std::uint32_t>(kGood.find("crate")) + 5}};
        desk.panel.addRunProblem(blown);
        QCOMPARE(desk.messages(), QStringList(QStringLiteral("crate blew up at t = 3.2 s")));
        QCOMPARE(desk.panel.errors(), 1);
        desk.click(desk.model().index(0, 0));
        QCOMPARE(desk.selection.current(), std::string("crate"));
        Diagnostic nowhere;
        nowhere.message = "the log folder is gone";
        desk.panel.addRunProblem(nowhere);
        desk.click(desk.model().index(1, 0)); // of no place: nothing to go to, nothing to fear
        QVERIFY(desk.document.replaceText(QStringLiteral("Typing"), desk.document.files()[0], "Tick = 0.01\n").ok());
        QCOMPARE(desk.panel.errors(), 2);
        desk.click(desk.model().index(0, 0)); // its place is in a text of the past
        desk.panel.clearRunProblems();
        QCOMPARE(desk.panel.errors(), 0);
    }

    void whatTheModelCheckFindsIsListed() {
        ProblemsDesk desk;
        QVERIFY(desk.open(kInWall));
        QCOMPARE(desk.messages(), QStringList()); // opening does not wait for it
        QTRY_COMPARE(desk.model().rowCount(), 1);
        QVERIFY2(desk.messages().at(0).contains(QStringLiteral("starts inside wall")), qPrintable(desk.messages().at(0)));
        QCOMPARE(desk.model().index(0, ProblemsModel::Place).data().toString(), QStringLiteral("main.sim:7:7"));
        QCOMPARE(desk.panel.warnings(), 1);
        desk.view().expandAll();
        desk.picture("model_check");
        desk.click(desk.model().index(0, 0));
        QCOMPARE(desk.selection.current(), std::string("crate"));

        int checks = 0;
        countChecks(desk, checks);
        QVERIFY(desk.button("applyFix").isEnabled());
        QTest::mouseClick(&desk.button("applyFix"), Qt::LeftButton);
        QVERIFY(desk.text() != kInWall);
        QTRY_COMPARE(checks, 1);
        QCOMPARE(desk.messages(), QStringList());
        desk.document.undo();
        QCOMPARE(desk.text(), kInWall);
        QTRY_COMPARE(desk.model().rowCount(), 1);
    }

    /// A run that is refused for what the check has found adds nothing to it.
    void aRefusedRunSaysNothingTwice() {
        ProblemsDesk desk;
        std::string text = kGood;
        QVERIFY(desk.open(text));
        Diagnostic found;
        found.code = Code::DeviceSetup;
        found.message = "one motor";
        auto* model = qobject_cast<ProblemsModel*>(&desk.model());
        model->setModelProblems({found}, desk.document.loaded());
        Diagnostic refused = found;
        refused.message = "the same motor";
        desk.panel.addRunProblem(refused);
        QCOMPARE(desk.messages(), QStringList{QStringLiteral("one motor")});
        refused.code = Code::ControllerFailed; // another reason
        desk.panel.addRunProblem(refused);
        QCOMPARE(desk.model().rowCount(), 2);
    }

    void theModelCheckFollowsTheText() {
        ProblemsDesk desk;
        QVERIFY(desk.open(kInWall));
        QTRY_COMPARE(desk.model().rowCount(), 1);
        int checks = 0;
        countChecks(desk, checks);
        const std::string file = desk.document.files()[0];
        QVERIFY(desk.document.replaceText(QStringLiteral("Typing"), file, kInWall + "// more\n").ok());
        QCOMPARE(desk.messages(), QStringList()); // what was found in the old text is gone at once
        QTRY_COMPARE(checks, 1);
        QCOMPARE(desk.model().rowCount(), 1);
        QVERIFY(desk.document.replaceText(QStringLiteral("Typing"), file, kInWall + "Robot other { Config=Crat }\n").ok());
        QTRY_COMPARE(checks, 2);
        QVERIFY(desk.panel.errors() > 0); // the errors first; a text that means nothing is not checked
        for (const QString& message : desk.messages()) QVERIFY(!message.contains(QStringLiteral("starts inside")));
    }

    void thePanelMayGoWhileItChecks() {
        for (int i = 0; i < 3; ++i) {
            ProblemsDesk desk;
            QVERIFY(desk.open(kInWall));
            auto* checker = desk.panel.findChild<ModelChecker*>();
            QVERIFY(QMetaObject::invokeMethod(checker->findChild<QTimer*>(), "timeout")); // starts at once
        }
    }

    void tenThousand() {
        ProblemsDesk desk;
        std::vector<Diagnostic> many;
        for (int i = 0; i < 10000; ++i) {
            Diagnostic d;
            d.severity = i % 3 == 0 ? Severity::Warning : Severity::Error;
            d.message = "problem " + std::to_string(i);
            d.notes.push_back({"see here", {0, {0, 1}}});
            many.push_back(d);
        }
        QVERIFY(desk.open(kGood));
        desk.panel.setRunProblems(many, desk.document.loaded());
        QCOMPARE(desk.model().rowCount(), 10000);
        QCOMPARE(desk.panel.errors(), 6666);
        desk.view().scrollToBottom();
        desk.panel.findChild<QLineEdit*>(QStringLiteral("problemFilter"))->setText(QStringLiteral("problem 77"));
        QCOMPARE(desk.model().rowCount(), 111);
        desk.panel.goTo(1);
        QCOMPARE(desk.view().currentIndex().row(), 0);
        desk.panel.goTo(-1);
        QCOMPARE(desk.view().currentIndex().row(), 110);
        desk.panel.goTo(1);
        QCOMPARE(desk.view().currentIndex().row(), 0);
    }
};

QTEST_MAIN(ProblemsPanelTest)
#include "problems_panel_test.moc"
