// Property rows during a run: values that need a reset are marked, and a paused robot shows its current pose.
#include <fstream>
#include <set>

#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QScrollArea>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/document/structure_edits.h"
#include "editor/properties/properties_panel.h"
#include "editor/running/session.h"
#include "eventually.h"

using namespace trundle;

namespace {

const char* const kFalling = R"(Tick = 0.01
RobotConfig Crate { Body box { Box hull { Size=0.2,0.2,0.2 Mass=1 Material=default Surface=default } } }
Robot crate { Config=Crate Pos=0,0,20 }
)";

struct RunningFixture {
    QTemporaryDir folder;
    std::unique_ptr<Application> application = makeApplication();
    Document document{*application};
    Selection selection;
    RunSession session{document, *application};
    PropertiesPanel panel{document, selection, &session};

    explicit RunningFixture(const std::string& text = kFalling) {
        const std::string path = folder.filePath(QStringLiteral("main.sim")).toStdString();
        std::ofstream(path, std::ios::binary) << text;
        panel.resize(340, 600);
        panel.show();
        if (!document.opening().open(path)) qFatal("not opened");
    }
    QLabel* note(const char* row, const char* which = "note") const {
        const auto* found = panel.findChild<QWidget*>(QStringLiteral("row.") + QLatin1String(row));
        return found ? found->findChild<QLabel*>(QLatin1String(which)) : nullptr;
    }
    /// True if the row is marked as applied at the next reset.
    bool waits(const char* row) const {
        const auto* found = panel.findChild<QWidget*>(QStringLiteral("row.") + QLatin1String(row));
        const auto* mark = found ? found->findChild<QToolButton*>(QStringLiteral("mark")) : nullptr;
        return mark && mark->toolTip().contains(QStringLiteral("after a reset"));
    }
    QTreeWidget* live() const { return panel.findChild<QTreeWidget*>(QStringLiteral("liveValues")); }
    /// "0.098 m/s"; "(none)" if no such value is shown.
    QString value(const char* name) const {
        const QList<QTreeWidgetItem*> found = live()->findItems(QLatin1String(name), Qt::MatchExactly);
        return found.isEmpty() || !live()->isVisible() ? QStringLiteral("(none)")
                                                       : (found[0]->text(1) + u' ' + found[0]->text(2)).simplified();
    }
};

} // namespace

class RunningRowsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// The help of a Param need not end with a full stop.
    void helpOfAParamEndsBeforeTheHint() {
        RunningFixture fixture(
            "RobotConfig Crate { Param side = 0.2 { Help=\"Side of it\" } Body box { Box hull { Size=$side,0.2,0.2 Mass=1 "
            "Material=default Surface=default } } }\nRobot crate { Config=Crate Pos=0,0,20 }\n");
        fixture.selection.select("RobotConfig.Crate");
        fixture.session.step();
        EVENTUALLY_EQUAL(fixture.session.state(), RunState::Paused);
        auto* row = fixture.panel.findChild<QWidget*>(QStringLiteral("row.param.side"));
        QVERIFY(row && row->findChild<QLineEdit*>(QStringLiteral("field")));
        QFocusEvent focus(QEvent::FocusIn);
        QCoreApplication::sendEvent(row->findChild<QLineEdit*>(QStringLiteral("field")), &focus);
        EVENTUALLY_EQUAL(fixture.panel.findChild<QLabel*>(QStringLiteral("helpText"))->text(),
                         QStringLiteral("Side of it. Takes effect after a reset."));
    }

    void aRobotShowsWhereItIs() {
        RunningFixture fixture;
        fixture.selection.select("crate");
        const auto now = [&fixture](const char* row) { return fixture.note(row, "now"); };
        QVERIFY(!now("Pos")->isVisible());
        fixture.session.step();
        EVENTUALLY_EQUAL(fixture.session.state(), RunState::Paused);
        EVENTUALLY(now("Pos")->isVisible());
        QCOMPARE(now("Pos")->text().simplified(), QStringLiteral("now 0.000 0.000 19.999"));
        QVERIFY(!now("Config")->isVisible());
        fixture.session.run(); // also while it runs
        EVENTUALLY(fixture.session.state() == RunState::Running &&
                   now("Pos")->text().simplified() != QStringLiteral("now 0.000 0.000 19.999"));
        QVERIFY(now("Pos")->isVisible());
        fixture.session.reset();
        EVENTUALLY(!now("Pos")->isVisible());
    }

    void showsLiveValuesOfSelection() {
        RunningFixture fixture;
        fixture.selection.select("crate");
        QVERIFY(!fixture.live()->isVisible());
        fixture.session.step();
        EVENTUALLY_EQUAL(fixture.value("speed"), QStringLiteral("0.098 m/s"));
        QCOMPARE(fixture.value("position"), QStringLiteral("0.000 0.000 19.999 m"));
        QCOMPARE(fixture.value("HPR"), QStringLiteral("0.000 0.000 0.000 °"));
        fixture.selection.select("crate.box.hull"); // the rows of a geom show its body
        QCOMPARE(fixture.value("velocity"), QStringLiteral("0.000 0.000 -0.098 m/s"));
        fixture.selection.clear(); // no selection: the rows of the run
        QCOMPARE(fixture.value("ticks"), QStringLiteral("1"));
        fixture.session.step();
        EVENTUALLY_EQUAL(fixture.value("ticks"), QStringLiteral("2"));
        QVERIFY(fixture.document.structure().setValues(QStringLiteral("Rename"), {{"crate.Pos", "0,0,21"}}).ok());
        fixture.selection.select("crate");
        QCOMPARE(fixture.value("speed"), QStringLiteral("0.196 m/s")); // of the run, not of the text
        fixture.session.reset();
        EVENTUALLY(!fixture.live()->isVisible());
    }

    void saysWhyARobotEnded() {
        RunningFixture fixture(std::string(kFalling) + "Robot other { Config=Crate Pos=3,0,20 }\n");
        const auto& banner = *fixture.panel.findChild<QLabel*>(QStringLiteral("endedBanner"));
        fixture.selection.select("crate.box");
        fixture.session.step();
        EVENTUALLY_EQUAL(fixture.session.state(), RunState::Paused);
        QVERIFY(banner.isHidden());
        QVERIFY(fixture.session.robots().push("crate/box", {0, 0, 1e9}, {0, 0, 20}));
        fixture.session.step();
        EVENTUALLY(banner.isVisible());
        QVERIFY2(banner.text().startsWith(QStringLiteral("crate has ended by a fault at t = 0.02 s: crate/box stopped: ")),
                 qPrintable(banner.text()));
        fixture.selection.select("other");
        QVERIFY(banner.isHidden());
        fixture.selection.select("crate");
        QVERIFY(banner.isVisible());
        fixture.session.reset();
        QVERIFY(banner.isHidden());
    }

    void namesAreWholeInANarrowPanel() {
        RunningFixture fixture;
        fixture.panel.resize(220, 600);
        fixture.selection.select("crate");
        fixture.session.step();
        EVENTUALLY_EQUAL(fixture.session.state(), RunState::Paused);
        const QTreeWidget& table = *fixture.live();
        EVENTUALLY(table.isVisible() && table.topLevelItemCount() > 0);
        const auto lines = [&table] {
            QStringList all;
            for (int i = 0; i < table.topLevelItemCount(); ++i) {
                const QTreeWidgetItem& row = *table.topLevelItem(i);
                const int room = row.isFirstColumnSpanned() ? table.viewport()->width() : table.columnWidth(0);
                if (table.fontMetrics().horizontalAdvance(row.text(0)) > room - 4)
                    return QStringList{QStringLiteral("cut: ") + row.text(0)};
                if (table.fontMetrics().horizontalAdvance(row.text(2)) > table.columnWidth(2))
                    return QStringList{QStringLiteral("cut unit")};
                all << row.text(0);
            }
            return all;
        };
        EVENTUALLY(lines().contains(QStringLiteral("angular rate")));
        const QList<QTreeWidgetItem*> found = fixture.live()->findItems(QStringLiteral("angular rate"), Qt::MatchExactly);
        QVERIFY(found[0]->isFirstColumnSpanned() && found[0]->toolTip(0).startsWith(QStringLiteral("angular rate\n")));
        const QTreeWidgetItem* below = table.topLevelItem(table.indexOfTopLevelItem(found[0]) + 1);
        QCOMPARE(below->text(2), QStringLiteral("rad/s"));
        const QStringList narrow = lines();
        fixture.session.step();
        EVENTUALLY_EQUAL(fixture.session.results().time(), 0.02);
        QCoreApplication::processEvents();
        QCOMPARE(lines(), narrow); // no line appears or disappears when a value changes
        fixture.panel.resize(420, 600);
        EVENTUALLY(lines().size() < narrow.size());
        QVERIFY(!fixture.live()->findItems(QStringLiteral("angular rate"), Qt::MatchExactly)[0]->isFirstColumnSpanned());
    }

    void aNameHasALineOfItsOwnOnlyWhereItMust() {
        RunningFixture fixture;
        fixture.selection.select("crate");
        fixture.session.step();
        EVENTUALLY_EQUAL(fixture.session.state(), RunState::Paused);
        const QTreeWidget& table = *fixture.live();
        EVENTUALLY(table.isVisible() && table.topLevelItemCount() > 0);
        const int padding = 2 * (table.style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, &table) + 1);
        const auto wrong = [&] {
            QStringList all;
            for (int i = 0; i < table.topLevelItemCount(); ++i) {
                const QTreeWidgetItem& row = *table.topLevelItem(i);
                const int needed = table.fontMetrics().horizontalAdvance(row.text(0)) + padding;
                if (row.isFirstColumnSpanned() != (needed > table.columnWidth(0))) all << row.text(0);
            }
            return all;
        };
        std::set<int> counts;
        for (int width = 260; width <= 420; width += 4) {
            fixture.panel.resize(width, 600);
            EVENTUALLY_EQUAL(wrong(), QStringList());
            counts.insert(table.topLevelItemCount());
        }
        QVERIFY(counts.size() > 2);
    }

    void severalSelectedObjectsShowTheirValuesEach() {
        RunningFixture fixture;
        fixture.selection.set({"crate", "crate.box.hull"});
        fixture.session.step();
        EVENTUALLY(fixture.live()->isVisible());
        const auto count = [&fixture](const char* text) {
            return fixture.live()->findItems(QLatin1String(text), Qt::MatchExactly).size();
        };
        EVENTUALLY_EQUAL(count("speed"), 2);
        QCOMPARE(count("crate"), 1);
        QCOMPARE(count("crate.box.hull"), 1);
        fixture.selection.select("crate");
        QCOMPARE(count("speed"), 1);
        QCOMPARE(count("crate"), 0); // the panel's own heading names the object
    }

    void aPlacedRobotShowsWhereItWasPut() {
        RunningFixture fixture;
        fixture.selection.select("crate");
        fixture.session.step();
        EVENTUALLY_EQUAL(fixture.value("speed"), QStringLiteral("0.098 m/s"));
        QVERIFY(fixture.session.robots().place("crate", {{1, 2, 3}, Quat::Identity()}));
        EVENTUALLY_EQUAL(fixture.value("position"), QStringLiteral("1.000 2.000 3.000 m"));
        QCOMPARE(fixture.value("speed"), QStringLiteral("0.000 m/s"));
        fixture.selection.select("crate.box");
        QCOMPARE(fixture.value("position"), QStringLiteral("1.000 2.000 3.000 m"));
    }

    /// In a panel too low for rows and live values the rows scroll; they do not shrink.
    void rowsKeepTheirHeightWhenLiveValuesAppear() {
        RunningFixture fixture;
        fixture.selection.select("crate.box.hull");
        fixture.panel.resize(340, 420);
        const auto heights = [&fixture] {
            QMap<QString, int> all;
            for (const QWidget* row : fixture.panel.findChildren<QWidget*>(QRegularExpression(QStringLiteral("^row\\..*"))))
                if (row->isVisible()) all.insert(row->objectName(), row->height());
            return all;
        };
        QMap<QString, int> before;
        do {
            before = heights();
            for (int i = 0; i < 5; ++i) QCoreApplication::processEvents();
        } while (heights() != before);
        QVERIFY(before.size() > 3);
        fixture.session.step();
        EVENTUALLY(fixture.live()->isVisible());
        for (int i = 0; i < 20; ++i) QCoreApplication::processEvents();
        QCOMPARE(heights(), before);
    }

    void newValuesMoveNothing() {
        RunningFixture fixture;
        fixture.selection.select("crate");
        fixture.session.step();
        EVENTUALLY_EQUAL(fixture.value("speed"), QStringLiteral("0.098 m/s"));
        const auto places = [&fixture] {
            QList<QRect> all;
            for (const QWidget* child : fixture.panel.findChildren<QWidget*>())
                if (child->isVisible()) all.append({child->mapTo(&fixture.panel, QPoint()), child->size()});
            for (int column = 0; column < 3; ++column) all.append(QRect(fixture.live()->columnViewportPosition(column), 0, 1, 1));
            return all;
        };
        QList<QRect> before;
        do { // waits for the layout: a scroll bar may appear or disappear
            before = places();
            for (int i = 0; i < 5; ++i) QCoreApplication::processEvents();
        } while (places() != before);
        QSignalSpy changes(&fixture.session.values(), &RunValues::changed), frames(&fixture.session, &RunSession::advanced);
        fixture.session.setSpeed(5);
        QElapsedTimer clock;
        clock.start();
        fixture.session.run();
        EVENTUALLY(frames.count() > 20 && fixture.session.results().time() > 1);
        QVERIFY2(changes.count() <= clock.elapsed() / 90 + 3, "ten times a second is enough");
        fixture.session.pause();
        EVENTUALLY_EQUAL(fixture.session.state(), RunState::Paused);
        EVENTUALLY(fixture.value("speed").section(u' ', 0, 0).toDouble() > 5);
        QCoreApplication::processEvents();
        QCOMPARE(places(), before);
    }

    void aLongNoteMakesTheRowsNoWider() {
        RunningFixture fixture;
        fixture.panel.resize(300, 600);
        fixture.selection.select("crate");
        fixture.session.step();
        EVENTUALLY_EQUAL(fixture.session.state(), RunState::Paused);
        QVERIFY(fixture.document.structure().setValues(QStringLiteral("Set Pos"), {{"crate.Pos", "-12.5,-12.5,20"}}).ok());
        EVENTUALLY(fixture.waits("Pos"));
        const auto* area = fixture.panel.findChild<QScrollArea*>();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
        QVERIFY(area->widget()->width() <= area->viewport()->width());
        QVERIFY(area->widget()->minimumSizeHint().width() <= area->viewport()->width());
    }

    void marksValuesWaitingForReset() {
        RunningFixture fixture;
        fixture.session.step();
        EVENTUALLY_EQUAL(fixture.session.state(), RunState::Paused);
        QVERIFY(!fixture.waits("Tick"));
        const auto places = [&fixture] {
            QList<QRect> all;
            for (const QWidget* row : fixture.panel.findChildren<QWidget*>(QRegularExpression(QStringLiteral("^row\\."))))
                all.append({row->mapTo(&fixture.panel, QPoint()), row->size()});
            return all;
        };
        const QList<QRect> before = places();
        QVERIFY(fixture.document.structure().setValues(QStringLiteral("Set Tick"), {{"Tick", "5 ms"}}).ok());
        EVENTUALLY(fixture.waits("Tick"));
        QVERIFY(!fixture.waits("Duration"));
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
        QCOMPARE(places(), before); // no row moves
        fixture.session.reset();
        EVENTUALLY(!fixture.waits("Tick"));
    }
};

QTEST_MAIN(RunningRowsTest)
#include "running_rows_test.moc"
