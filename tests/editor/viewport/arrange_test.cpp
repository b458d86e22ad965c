// Dropping objects onto their support, aligning and distributing them, and copying them in rows.
#include <QtTest>

#include <set>

#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
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

    /// The last selected one stays; low, middle and high sides of boxes of unlike sizes.
    void alignsEachSide_data() {
        QTest::addColumn<int>("axis");
        QTest::addColumn<int>("to");
        QTest::addColumn<QString>("pos"); // of the small one; the large one is 0.6 x 0.4 x 0.8 about (1, 2, 0.4)
        QTest::newRow("x low") << 0 << int(AlignTo::Low) << "Pos=0.8,0,0.1";
        QTest::newRow("x middle") << 0 << int(AlignTo::Middle) << "Pos=1,0,0.1";
        QTest::newRow("x high") << 0 << int(AlignTo::High) << "Pos=1.2,0,0.1";
        QTest::newRow("y low") << 1 << int(AlignTo::Low) << "Pos=0,1.9,0.1";
        QTest::newRow("y high") << 1 << int(AlignTo::High) << "Pos=0,2.1,0.1";
        QTest::newRow("z low") << 2 << int(AlignTo::Low) << "Pos=0,0,0.1";
        QTest::newRow("z middle") << 2 << int(AlignTo::Middle) << "Pos=0,0,0.4";
        QTest::newRow("z high") << 2 << int(AlignTo::High) << "Pos=0,0,0.7";
    }
    void alignsEachSide() {
        QFETCH(int, axis);
        QFETCH(int, to);
        QFETCH(QString, pos);
        const QByteArray large = "Static large { Config=Large Pos=1,2,0.4 }\n";
        QVERIFY(m_window->open(
            "StaticConfig Small { Box b { Size=0.2,0.2,0.2 } }\nStaticConfig Large { Box b { Size=0.6,0.4,0.8 } }\n"
            "Static small { Config=Small Pos=0,0,0.1 }\n" +
            large));
        m_window->selection.set({"small", "large"});
        alignSelected(viewContext(), axis, static_cast<AlignTo>(to));
        QVERIFY2(m_window->text().contains(pos.toLatin1() + " }") && m_window->text().contains(large),
                 m_window->text().constData());
    }

    /// In the order of their places, not of their selection; the outer ones stay.
    void distributesByPlace() {
        QByteArray text = "StaticConfig Small { Box b { Size=0.2,0.2,0.2 } }\n";
        const std::pair<const char*, const char*> places[] = {{"a", "3,0,1"}, {"b", "0,5,2"}, {"c", "0.5,1,3"}, {"d", "1,2,4"}};
        for (const auto& [name, pos] : places) text += QByteArray("Static ") + name + " { Config=Small Pos=" + pos + " }\n";
        QVERIFY(m_window->open(text));
        m_window->selection.set({"d", "a", "b", "c"});
        distributeSelected(viewContext(), 0);
        for (const char* pos : {"a { Config=Small Pos=3,0,1 }", "b { Config=Small Pos=0,5,2 }", "c { Config=Small Pos=1,1,3 }",
                                "d { Config=Small Pos=2,2,4 }"})
            QVERIFY2(m_window->text().contains(pos), m_window->text().constData());
        m_window->document.edits().undo();
        m_window->selection.clear();
        for (const auto& [call, why] : {std::pair<std::function<void()>, const char*>{[&] { dropToFloor(viewContext()); },
                                                                                      "Select the objects to drop to the floor."},
                                        {[&] { alignSelected(viewContext(), 0, AlignTo::Low); }, "Select two or more objects."},
                                        {[&] {
                                             copyInRows(viewContext(), {{2, 1, 1}, {1, 1, 1}, false});
                                         },
                                         "Select what is to be copied."},
                                        {[&] {
                                             copyInRows(viewContext(), {{2, 1, 1}, {1, 1, 1}, true});
                                         },
                                         "A Grid is made of one robot or one piece of scenery."}}) {
            call();
            QCOMPARE(m_window->refusals.back(), QLatin1String(why));
        }
        m_window->selection.set({"a", "b"});
        copyInRows(viewContext(), {{2, 1, 1}, {1, 1, 1}, true});
        QCOMPARE(m_window->refusals.back(), QStringLiteral("A Grid is made of one robot or one piece of scenery."));
        QCOMPARE(m_window->text(), text);
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

    void gridStartsAtPieceOfScenery() {
        const QByteArray text = "StaticConfig Post { Param h = 1 m Box b { Size=0.2,0.2,$h Pos=0,0,$(h/2) } }\n"
                                "// a row of posts\nStatic post { Config=Post h=0.5 }\n";
        QVERIFY(m_window->open(text));
        m_window->selection.select("post");
        copyInRows(viewContext(), {{4, 1, 1}, {0.5, 1, 1}, true});
        QVERIFY(!m_window->document.loaded()->diagnostics.hasErrors());
        QVERIFY2(m_window->text().contains("Grid post { Pos=0.75,0,0 Count=4,1 Spacing=0.5,1 Config=Post h=0.5 }"),
                 m_window->text().constData());
        const auto& statics = m_window->document.loaded()->experiment->statics;
        QCOMPARE(statics.size(), std::size_t(4));
        QVERIFY(statics[0].pose.position.norm() < 1e-9);
        QVERIFY((statics[3].pose.position - Vec3(1.5, 0, 0)).norm() < 1e-9);
        m_window->selection.select("post_1");
        QVERIFY(!gridRefusal(viewContext()).isEmpty());
        m_window->document.edits().undo();
        QCOMPARE(m_window->text(), text);
    }

    /// Its pose is that of all members, computed from index: the numbers of one would replace it.
    void aRobotOfARepeatBecomesNoGrid() {
        const QByteArray text = "RobotConfig Kit { Body c { Box b { Size=0.2,0.2,0.2 Mass=1 } } }\n"
                                "Repeat row { Count=2 Robot cart { Config=Kit Pos=$(0.5*index),0,0 } }\n";
        QVERIFY(m_window->open(text));
        m_window->selection.select("row_1.cart");
        QVERIFY(gridRefusal(viewContext()).startsWith(QStringLiteral("row_1.cart is in row")));
        copyInRows(viewContext(), {{3, 2, 1}, {0.5, 0.6, 1}, true});
        QCOMPARE(m_window->text(), text);
        QCOMPARE(m_window->refusals.size(), std::size_t(1));
    }

    void announcesRotatedGrid() {
        m_window->selection.select("robot0");
        QVERIFY(!gridIsTurned(viewContext()));
        QVERIFY(m_window->open(QByteArray(kRoom).replace("Pos=-0.5,0,0 HPR=0,0,0", "Pos=-0.5,0,0 HPR=30,0,0")));
        m_window->selection.select("robot0");
        QVERIFY(gridIsTurned(viewContext()));
        ArrayDialog dialog({0.5, 0.5, 0.3}, 1, {}, true);
        QCOMPARE(dialog.findChild<QSpinBox*>(QStringLiteral("countX"))->findChild<QLineEdit*>()->selectedText(),
                 QStringLiteral("3"));
        const auto* summary = dialog.findChild<QLabel*>(QStringLiteral("summary"));
        QCOMPARE(summary->text(), QStringLiteral("3 in all, with the original"));
        dialog.findChild<QCheckBox*>(QStringLiteral("asGrid"))->setChecked(true);
        QCOMPARE(summary->text(), QStringLiteral("A Grid of 3 × 1; its rows are turned with the original"));
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

    void copiesComeBehindTheirOriginals() {
        const QByteArray crate = "  // a crate\n  Box crate { Size=0.4,0.4,0.4 Pos=0,0,0.2 } // of wood\n";
        const QByteArray head = "StaticConfig Yard {\n" + crate;
        const QByteArray rest =
            "\n  // a ball\n  Sphere ball { Radius=0.1 Pos=5,0,0.1 }\n}\nStatic yard { Config=Yard Pos=0,0,0 }\n";
        QVERIFY(m_window->open(head + rest));
        m_window->selection.select("yard.crate");
        copyInRows(viewContext(), {{3, 1, 1}, {1, 0, 0}, false});
        QCOMPARE(m_window->text(), head +
                                       "  Box crate2 { Size=0.4,0.4,0.4 Pos=1,0,0.2 }\n"
                                       "  Box crate3 { Size=0.4,0.4,0.4 Pos=2,0,0.2 }\n" +
                                       rest);
        QCOMPARE(m_window->selection.paths(), (std::vector<std::string>{"yard.crate", "yard.crate2", "yard.crate3"}));
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

    /// What is below one corner alone holds it.
    void restsOnOneCorner_data() {
        QTest::addColumn<QByteArray>("post");
        QTest::addColumn<double>("height");
        for (const char* place : {"0.46,0.3", "0.46,-0.3", "-0.46,0.3", "-0.46,-0.3"})
            QTest::newRow(place) << QByteArray("Static post { Config=Post Pos=") + place + ",0 }\n" << 0.7;
        QTest::newRow("in the middle") << QByteArray("Static post { Config=Post Pos=0,0,0 }\n") << 0.7;
        QTest::newRow("beside it") << QByteArray("Static post { Config=Post Pos=0.6,0.3,0 }\n") << 0.;
        QTest::newRow("two of unlike heights") << QByteArray("Static post { Config=Post Pos=0.46,0.3,0 }\n"
                                                             "Static low { Config=Low Pos=-0.46,-0.3,0 }\n")
                                               << 0.7;
    }
    void restsOnOneCorner() {
        QFETCH(QByteArray, post);
        QFETCH(double, height);
        QVERIFY(m_window->open("StaticConfig Post { Box b { Size=0.1,0.1,0.7 Pos=0,0,0.35 } }\n"
                               "StaticConfig Low { Box b { Size=0.1,0.1,0.2 Pos=0,0,0.1 } }\n"
                               "StaticConfig Slab { Box b { Size=1,0.7,0.1 Pos=0,0,0.05 } }\n" +
                               post + "Static slab { Config=Slab Pos=0,0,3 }\n"));
        m_window->selection.select("slab");
        dropToFloor(viewContext());
        const auto& statics = m_window->document.loaded()->experiment->statics;
        QVERIFY(std::abs(statics.back().pose.position.z() - height) < 1e-9);
    }

    /// The rows of a Grid are turned with its first member, and the others have their places in them.
    void gridOfATurnedRobot() {
        QVERIFY(m_window->open(QByteArray(kRoom).replace("Pos=-0.5,0,0 HPR=0,0,0", "Pos=-0.5,0.25,0 HPR=90,0,0")));
        m_window->selection.select("robot0");
        copyInRows(viewContext(), {{3, 2, 1}, {0.5, 0.75, 1}, true});
        const auto& robots = m_window->document.loaded()->experiment->robots;
        QCOMPARE(robots.size(), std::size_t(7));
        QVERIFY((robots[0].pose.position - Vec3(-0.5, 0.25, 0)).norm() < 1e-6);
        QVERIFY((robots[5].pose.position - Vec3(-0.5 - 0.75, 0.25 + 1, 0)).norm() < 1e-6);
    }

    void asManyCopiesAsAreMade() {
        QVERIFY(m_window->open("StaticConfig Post { Box b { Size=0.1,0.1,0.7 } }\nStatic post { Config=Post }\n"));
        m_window->selection.select("post");
        copyInRows(viewContext(), {{401, 1, 1}, {1, 1, 1}, false});
        QCOMPARE(m_window->refusals.size(), std::size_t(1));
        copyInRows(viewContext(), {{20, 20, 1}, {1, 1, 1}, false});
        QCOMPARE(m_window->refusals.size(), std::size_t(1));
        QCOMPARE(m_window->document.loaded()->experiment->statics.size(), std::size_t(400));
    }

    /// A Grid has no third direction.
    void dialogOfAGrid() {
        ArrayDialog dialog({0.5, 0.6, 0.3}, 1, {});
        const auto count = [&](const char* axis) {
            return dialog.findChild<QSpinBox*>(QStringLiteral("count") + QLatin1String(axis));
        };
        const auto* spacing = dialog.findChild<QDoubleSpinBox*>(QStringLiteral("spacingZ"));
        auto* asGrid = dialog.findChild<QCheckBox*>(QStringLiteral("asGrid"));
        count("Z")->setValue(4);
        QVERIFY(count("Z")->isEnabled() && spacing->isEnabled() && asGrid->isEnabled());
        QCOMPARE(dialog.copy().count[2], 4);
        asGrid->setChecked(true);
        QVERIFY(!count("Z")->isEnabled() && !spacing->isEnabled());
        QVERIFY(dialog.copy().asGrid && dialog.copy().count[2] == 1);
        const ArrayDialog refused({0.5, 0.6, 0.3}, 1, QStringLiteral("no Grid of this"));
        const auto* refusedGrid = refused.findChild<QCheckBox*>(QStringLiteral("asGrid"));
        QVERIFY(!refusedGrid->isEnabled());
        QCOMPARE(refusedGrid->toolTip(), QStringLiteral("no Grid of this"));
    }

private:
    const ViewContext& viewContext() { return m_window->view().context(); }
    std::unique_ptr<RenderService> m_render;
    std::unique_ptr<ViewWindow> m_window;
};

QTEST_MAIN(ArrangeTest)
#include "arrange_test.moc"
