// Rows while an experiment runs: what waits for a reset says so, and a paused robot shows where it is.
#include <fstream>

#include <QLabel>
#include <QScrollArea>
#include <QTemporaryDir>
#include <QTest>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/properties/properties_panel.h"
#include "editor/running/session.h"
#include "eventually.h"

using namespace trundle;

namespace {

const char* const kFalling = R"(Tick = 0.01
RobotConfig Crate { Body box { Box hull { Size=0.2,0.2,0.2 Mass=1 Material=default Surface=default } } }
Robot crate { Config=Crate Pos=0,0,20 }
)";

struct RunningDesk {
    QTemporaryDir folder;
    std::unique_ptr<Parts> parts = makeParts();
    Document document{*parts};
    Selection selection;
    RunSession session{document, *parts};
    PropertiesPanel panel{document, selection, &session};

    RunningDesk() {
        const std::string path = folder.filePath(QStringLiteral("main.sim")).toStdString();
        std::ofstream(path, std::ios::binary) << kFalling;
        panel.resize(340, 600);
        panel.show();
        if (!document.open(path)) qFatal("not opened");
    }
    QLabel* note(const char* row) const {
        const auto* found = panel.findChild<QWidget*>(QStringLiteral("row.") + QLatin1String(row));
        return found ? found->findChild<QLabel*>(QStringLiteral("note")) : nullptr;
    }
};

} // namespace

class RunningRowsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aPausedRobotShowsWhereItIs() {
        RunningDesk desk;
        desk.selection.select("crate");
        QVERIFY(!desk.note("Pos")->isVisible());
        desk.session.step();
        EVENTUALLY_EQUAL(desk.session.state(), RunState::Paused);
        EVENTUALLY(desk.note("Pos")->isVisible());
        QVERIFY2(desk.note("Pos")->text().startsWith(QStringLiteral("now 0.000, 0.000, ")), qPrintable(desk.note("Pos")->text()));
        QVERIFY(!desk.note("Config")->isVisible());
        desk.session.reset();
        EVENTUALLY(!desk.note("Pos")->isVisible());
    }

    void aLongNoteMakesTheRowsNoWider() {
        RunningDesk desk;
        desk.panel.resize(300, 600);
        desk.selection.select("crate");
        desk.session.step();
        EVENTUALLY_EQUAL(desk.session.state(), RunState::Paused);
        QVERIFY(desk.document.setValues(QStringLiteral("Set Pos"), {{"crate.Pos", "-12.5,-12.5,20"}}).ok());
        EVENTUALLY(desk.note("Pos")->text().contains(QStringLiteral("after reset")));
        const auto* area = desk.panel.findChild<QScrollArea*>();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
        QVERIFY(area->widget()->width() <= area->viewport()->width());
        QVERIFY(area->widget()->minimumSizeHint().width() <= area->viewport()->width());
    }

    void whatWaitsForAResetSaysSo() {
        RunningDesk desk;
        desk.session.step();
        EVENTUALLY_EQUAL(desk.session.state(), RunState::Paused);
        QVERIFY(!desk.note("Tick")->isVisible());
        QVERIFY(desk.document.setValues(QStringLiteral("Set Tick"), {{"Tick", "5 ms"}}).ok());
        EVENTUALLY(desk.note("Tick")->isVisible());
        QCOMPARE(desk.note("Tick")->text(), QStringLiteral("after reset"));
        QVERIFY(!desk.note("Duration")->isVisible());
        desk.session.reset();
        EVENTUALLY(!desk.note("Tick")->isVisible());
    }
};

QTEST_MAIN(RunningRowsTest)
#include "running_rows_test.moc"
