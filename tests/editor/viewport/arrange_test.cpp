// Dropping objects onto their support, aligning and distributing them, and copying them in rows.
#include <QtTest>

#include <set>

#include <QCheckBox>
#include <QSpinBox>

#include "editor/viewport/tools/arrange.h"
#include "editor/viewport/tools/array_dialog.h"
#include "editor/viewport/view_window.h"

using namespace trundle;

class ArrangeTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_render = RenderService::startInBackground(); }
    void init() {
        m_window = std::make_unique<ViewWindow>(m_render.get());
        QVERIFY(m_window->open(kRoom));
    }
    void cleanup() { m_window.reset(); }

    void dropsOntoSupport() {
        QVERIFY(m_window->open(
            QByteArray(kRoom).replace("Pos=-0.5,0,0", "Pos=-0.5,0,0.3").replace("Pos=0.5,0.3,0", "Pos=0.5,0.3,-0.2")));
        m_window->selection.set({"robot0", "robot1"});
        m_window->trigger("tool.drop");
        QVERIFY2(m_window->text().contains("Pos=-0.5,0,0 ") && m_window->text().contains("Pos=0.5,0.3,0 "),
                 m_window->text().constData());
        QCOMPARE(m_window->document.edits().history().entries().size(), std::size_t(1));
        // One above the other.
        QVERIFY(m_window->open(QByteArray(kRoom).replace("Pos=0.5,0.3,0", "Pos=-0.5,0,1")));
        m_window->selection.select("robot1");
        m_window->trigger("tool.drop");
        QVERIFY2(m_window->text().contains("Pos=-0.5,0,0.14"), m_window->text().constData());
    }

    void alignsToLastSelected() {
        m_window->selection.set({"robot0", "robot1"});
        alignSelected(viewContext(), 1, AlignTo::Middle);
        QVERIFY2(m_window->text().contains("Pos=-0.5,0.3,0"), m_window->text().constData());
        alignSelected(viewContext(), 0, AlignTo::Low);
        QVERIFY2(m_window->text().contains("Pos=0.5,0.3,0 HPR=0,0,0 } // the first"), m_window->text().constData());
        m_window->document.edits().undo();
        m_window->document.edits().undo();
        QCOMPARE(m_window->text(), kRoom);
    }

    void distributingNeedsThree() {
        m_window->selection.set({"robot0", "robot1"});
        distributeSelected(viewContext(), 0);
        QCOMPARE(m_window->refusals.back(), QStringLiteral("Select three or more objects."));
        QVERIFY(m_window->open(QByteArray(kRoom) + "Robot robot2 { Config=SimpleRobot Pos=-0.3,1,0 }\n"));
        m_window->selection.set({"robot2", "robot0", "robot1"});
        distributeSelected(viewContext(), 0);
        QVERIFY2(m_window->text().contains("robot2 { Config=SimpleRobot Pos=0,1,0 }"), m_window->text().constData());
    }

    void rowsOfCopiesAreOneEdit() {
        m_window->selection.select("robot0");
        copyInRows(viewContext(), {{2, 2, 1}, {0.4, 0.5, 1}, false});
        for (const char* pos : {"Pos=-0.5,0,0", "Pos=-0.1,0,0", "Pos=-0.5,0.5,0", "Pos=-0.1,0.5,0"})
            QVERIFY2(m_window->text().contains(pos), m_window->text().constData());
        QCOMPARE(m_window->document.loaded()->experiment->robots.size(), std::size_t(5));
        QVERIFY(!m_window->document.loaded()->diagnostics.hasErrors());
        QCOMPARE(m_window->selection.paths().size(), std::size_t(4));
        QCOMPARE(m_window->document.edits().history().entries().size(), std::size_t(1));
        m_window->document.edits().undo();
        QCOMPARE(m_window->text(), kRoom);
    }

    void copiesFillAllThreeDirections() {
        m_window->selection.select("robot0");
        copyInRows(viewContext(), {{2, 3, 4}, {0.4, 0.5, 0.6}, false});
        std::set<std::array<long, 3>> steps;
        for (const RobotSpec& robot : m_window->document.loaded()->experiment->robots) {
            const Vec3 by = robot.pose.position - Vec3(-0.5, 0, 0);
            if (robot.name != "robot1")
                steps.insert({std::lround(by.x() / 0.4), std::lround(by.y() / 0.5), std::lround(by.z() / 0.6)});
        }
        QCOMPARE(steps.size(), std::size_t(2 * 3 * 4));
        QVERIFY((*steps.begin() == std::array<long, 3>{0, 0, 0}) && (*steps.rbegin() == std::array<long, 3>{1, 2, 3}));
    }

    void gridStartsAtRobot() {
        m_window->selection.select("robot0");
        copyInRows(viewContext(), {{3, 2, 1}, {0.5, 0.6, 1}, true});
        const auto& robots = m_window->document.loaded()->experiment->robots;
        QVERIFY(!m_window->document.loaded()->diagnostics.hasErrors());
        QCOMPARE(robots.size(), std::size_t(7));
        QVERIFY((robots[0].pose.position - Vec3(-0.5, 0, 0)).norm() < 1e-9);
        QVERIFY((robots[5].pose.position - Vec3(0.5, 0.6, 0)).norm() < 1e-9);
        QVERIFY2(m_window->text().contains(
                     "Grid robot0 { Config=SimpleRobot Pos=0,0.3,0 Count=3,2 Spacing=0.5,0.6 HPR=0,0,0 } // the first"),
                 m_window->text().constData());
        m_window->document.edits().undo();
        QCOMPARE(m_window->text(), kRoom);
        m_window->selection.select("robot0");
        copyInRows(viewContext(), {{3, 1, 1}, {-0.5, 0.6, 1}, true}); // in the negative direction: a Grid's Spacing has no sign
        QVERIFY2(m_window->text().contains("Pos=-1,0,0 Count=3,1 Spacing=0.5,0.6"), m_window->text().constData());
    }

    void announcesRotatedGrid() {
        m_window->selection.select("robot0");
        QVERIFY(!gridIsTurned(viewContext()));
        QVERIFY(m_window->open(QByteArray(kRoom).replace("Pos=-0.5,0,0 HPR=0,0,0", "Pos=-0.5,0,0 HPR=30,0,0")));
        m_window->selection.select("robot0");
        QVERIFY(gridIsTurned(viewContext()));
        ArrayDialog dialog({0.5, 0.5, 0.3}, 1, {}, true);
        const auto* summary = dialog.findChild<QLabel*>(QStringLiteral("summary"));
        QCOMPARE(summary->text(), QStringLiteral("3 in all, with the original"));
        dialog.findChild<QCheckBox*>(QStringLiteral("asGrid"))->setChecked(true);
        QCOMPARE(summary->text(), QStringLiteral("A Grid of 3 × 1 robots; its rows are turned with the robot"));
    }

    void tooManyCopiesAreRefused() {
        m_window->selection.select("robot0");
        copyInRows(viewContext(), {{200, 200, 1}, {1, 1, 1}, false});
        QCOMPARE(m_window->text(), kRoom);
        QCOMPARE(m_window->refusals.size(), std::size_t(1));
    }

    void partsOfAConfigAreCopiedInIt() {
        QVERIFY(m_window->open(
            "StaticConfig Yard {\n  Box crate { Size=0.4,0.4,0.4 Pos=0,0,0.2 }\n}\nStatic yard { Config=Yard Pos=0,0,0 }\n"));
        m_window->selection.select("yard.crate");
        copyInRows(viewContext(), {{3, 1, 1}, {1, 0, 0}, false});
        QVERIFY2(m_window->text().contains("Pos=1,0,0.2") && m_window->text().contains("Pos=2,0,0.2"),
                 m_window->text().constData());
        QCOMPARE(m_window->document.loaded()->experiment->statics[0].geoms->size(), std::size_t(3));
    }

    void dialogShowsSummary() {
        ArrayDialog dialog({0.5, 0.5, 0.3}, 3, {});
        dialog.findChild<QSpinBox*>(QStringLiteral("countX"))->setValue(4);
        dialog.findChild<QSpinBox*>(QStringLiteral("countY"))->setValue(2);
        QCOMPARE(dialog.copy().count, (std::array<int, 3>{4, 2, 1}));
        QVERIFY((dialog.copy().spacing - Vec3(0.5, 0.5, 0.3)).norm() < 1e-9);
        QVERIFY(!dialog.copy().asGrid);
        QCOMPARE(dialog.findChild<QLabel*>(QStringLiteral("summary"))->text(), QStringLiteral("24 in all, with the 3 originals"));
    }

private:
    const ViewContext& viewContext() { return m_window->view().context(); }
    std::unique_ptr<RenderService> m_render;
    std::unique_ptr<ViewWindow> m_window;
};

QTEST_MAIN(ArrangeTest)
#include "arrange_test.moc"
