// Scaling robots and Statics through the Params of their configs.
#include <QtTest>

#include <QLabel>

#include "editor/viewport/gizmo_hand.h"
#include "scene/shapes/extents.h"

using namespace trundle;

class ScaleTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_render = RenderService::startInBackground(); }
    void init() { m_window = std::make_unique<ViewWindow>(m_render.get()); }
    void cleanup() { m_window.reset(); }

    void aWallIsSizedThroughItsParams() {
        const QByteArray walled = "#import objects/wall.sim\nStatic wall { Config=Wall Pos=1,0.5,0 HPR=90,0,0 }\n";
        open(walled);
        take("wall", "tool.scale");
        const Vec3 middle(1, 0.5, 0.25);
        // Its x axis is the y axis of the world: one side moves, the opposite side stays.
        dragBy({GizmoHandle::Kind::Size, 0}, {0, 0.5, 0}, Qt::NoModifier, middle);
        QVERIFY2(m_window->text().contains("Pos=1,0.75,0 HPR=90,0,0 length=2.5 }"), m_window->text().constData());
        QCOMPARE(m_window->document.edits().history().entries().size(), std::size_t(1));
        QCOMPARE(m_window->document.edits().history().entries()[0].name, QStringLiteral("Resize wall"));
        m_window->document.edits().undo();
        QCOMPARE(m_window->text(), walled);
        dragBy({GizmoHandle::Kind::Size, 0, -1}, {0, -0.5, 0}, Qt::NoModifier, middle);
        QVERIFY2(m_window->text().contains("Pos=1,0.25,0 HPR=90,0,0 length=2.5 }"), m_window->text().constData());
        // Only upwards from the floor: there is no handle below.
        QVERIFY(!m_window->view().tools().gizmo().spot({GizmoHandle::Kind::Size, 2, -1}));
        dragBy({GizmoHandle::Kind::Size, 2}, {0, 0, 0.2}, Qt::NoModifier, {1, 0.25, 0.25});
        QVERIFY2(m_window->text().contains("Pos=1,0.25,0 HPR=90,0,0 length=2.5 height=0.7 }"), m_window->text().constData());
        const GeomSpec& bricks = m_window->document.loaded()->experiment->statics.at(0).geoms->at(0);
        QVERIFY((bricks.size - Vec3(2.5, 0.1, 0.7)).norm() < 1e-9);
        QVERIFY(std::abs(bricks.pose.position.z() - 0.35) < 1e-9); // on the floor
        // A typed number becomes the Param's value.
        const QPointF from = *m_window->view().tools().gizmo().spot({GizmoHandle::Kind::Size, 0});
        m_window->press(from);
        m_window->move(from + QPointF(12, 12), {}, Qt::LeftButton);
        m_window->type(QStringLiteral("3"));
        m_window->key(Qt::Key_Return);
        m_window->release(from);
        QVERIFY2(m_window->text().contains("length=3 "), m_window->text().constData());
        const auto* banner = m_window->panel->findChild<QWidget*>(QStringLiteral("viewportBanner"));
        QVERIFY(!banner->isVisible());
    }

    void aGridIsSizedThroughTheParamsOfItsConfig_data() {
        QTest::addColumn<QByteArray>("layout");
        QTest::newRow("Grid") << QByteArray("Grid planks { Config=Plank Pos=0,0,0.5 Count=2,1 Spacing=2 ");
        QTest::newRow("turned Grid") << QByteArray("Grid planks { Config=Plank Pos=0.5,0,0.5 HPR=90,0,0 Count=1,2 Spacing=1.5 ");
        QTest::newRow("Scatter") << QByteArray("Scatter planks { Config=Plank Pos=0,0,0.5 Count=3 Area=-1,-1,1,1 ");
    }
    /// All members are scaled at once by the handles of the first one; members of a Grid keep their positions.
    void aGridIsSizedThroughTheParamsOfItsConfig() {
        QFETCH(QByteArray, layout);
        const QByteArray text = "RobotConfig Plank {\n  Param long = 0.8\n  Body b { Box p { Size=$long,0.2,0.2 Mass=1 } }\n}\n"
                                "Robot other { Config=Plank Pos=9,9,1 }\n" +
                                layout + "}\n";
        open(text);
        take("planks", "tool.scale");
        const auto robots = m_window->document.loaded()->experiment->robots;
        const auto first = std::ranges::find_if(robots, [](const RobotSpec& robot) { return robot.name != "other"; });
        const Pose at = first->pose;
        dragBy({GizmoHandle::Kind::Size, 0}, at.rotation * Vec3(0.1, 0, 0), Qt::NoModifier, at.position);
        const QByteArray after = m_window->text();
        QVERIFY2(after.contains(layout + "long=1 }"), after.constData()); // both sides move
        const ExperimentSpec& now = *m_window->document.loaded()->experiment;
        QCOMPARE(now.robots.size(), robots.size());
        for (std::size_t i = 0; i < robots.size(); ++i) {
            // A Scatter places larger members again, so that they do not overlap.
            if (!layout.startsWith("Scatter")) QVERIFY((now.robots[i].pose.position - robots[i].pose.position).norm() < 1e-12);
            const double length = now.robots[i].config->bodies[0].geoms[0].size.x();
            QCOMPARE(length, now.robots[i].name == "other" ? 0.8 : 1.0);
        }
        QCOMPARE(m_window->document.edits().history().entries().size(), std::size_t(1));
        m_window->document.edits().undo();
        QCOMPARE(m_window->text(), text);
    }

    void aLayoutHasHandlesForItsExtent_data() {
        QTest::addColumn<QByteArray>("layout");
        QTest::addColumn<int>("side");
        QTest::addColumn<Vec3>("by");
        QTest::addColumn<bool>("alt");
        QTest::addColumn<QByteArray>("after");
        const QByteArray grid = "Grid balls { Config=Ball Pos=0,0,0.1 Count=3,2 Spacing=";
        QTest::newRow("Grid") << grid + "0.5,0.4 }" << 1 << Vec3(0.4, 0, 0) << false
                              << QByteArray("Pos=0.2,0,0.1 Count=3,2 Spacing=0.7,0.4 }");
        QTest::newRow("its other side") << grid + "0.5,0.4 }" << -1 << Vec3(-0.4, 0, 0) << false
                                        << QByteArray("Pos=-0.2,0,0.1 Count=3,2 Spacing=0.7,0.4 }");
        QTest::newRow("both sides") << grid + "0.5,0.4 }" << 1 << Vec3(0.2, 0, 0) << true
                                    << QByteArray("Pos=0,0,0.1 Count=3,2 Spacing=0.7,0.4 }");
        QTest::newRow("one number") << grid + "0.5 }" << 1 << Vec3(0.4, 0, 0) << false
                                    << QByteArray("Pos=0.2,0,0.1 Count=3,2 Spacing=0.7,0.5 }");
        QTest::newRow("in centimetres") << grid + "50 cm,0.4 }" << 1 << Vec3(0.4, 0, 0) << false
                                        << QByteArray("Spacing=70 cm,0.4 }");
        QTest::newRow("turned") << QByteArray("Grid balls { Config=Ball Pos=0,0,0.1 HPR=90,0,0 Count=3 Spacing=0.3 }") << 1
                                << Vec3(0, 0.2, 0) << false << QByteArray("Pos=0,0.1,0.1 HPR=90,0,0 Count=3 Spacing=0.4 }");
        const QByteArray scatter = "Scatter balls { Config=Ball Pos=0,0,0.1 Count=3 Area=-0.6,-0.6,0.6,0.6 }";
        QTest::newRow("Scatter") << scatter << 1 << Vec3(0.4, 0, 0) << false << QByteArray("Area=-0.6,-0.6,1,0.6 }");
        QTest::newRow("below") << scatter << -1 << Vec3(-0.4, 0, 0) << false << QByteArray("Area=-1,-0.6,0.6,0.6 }");
        QTest::newRow("both edges") << scatter << 1 << Vec3(0.1, 0, 0) << true << QByteArray("Area=-0.7,-0.6,0.7,0.6 }");
    }
    /// Beside those of the first member: Spacing of a Grid, whose other side stays, and Area of a Scatter.
    void aLayoutHasHandlesForItsExtent() {
        QFETCH(QByteArray, layout);
        QFETCH(int, side);
        QFETCH(Vec3, by);
        QFETCH(bool, alt);
        QFETCH(QByteArray, after);
        const QByteArray text = "RobotConfig Ball {\n  Body b { Sphere s { Radius=0.05 Mass=1 } }\n}\n" + layout + "\n";
        open(text);
        take("balls", "tool.scale");
        m_window->panel->settings().setSteps(0.1, 15);
        const GizmoHandle handle{GizmoHandle::Kind::Size, 0, side, true};
        if (alt) { // pressed without it, since Alt and the left button orbit
            const Vec3 edge(0.6, 0, 0.1);
            const QPointF from = m_window->view().tools().gizmo().spot(handle).value(),
                          to = from + *m_window->view().camera().pixelOf(edge + by) - *m_window->view().camera().pixelOf(edge);
            m_window->press(from);
            m_window->move(to, Qt::AltModifier, Qt::LeftButton);
            QTRY_VERIFY2(m_window->text().contains(after), m_window->text().constData());
            m_window->release(to, Qt::LeftButton, Qt::AltModifier);
        } else {
            dragBy(handle, by, Qt::NoModifier, {0, 0, 0.1});
        }
        QVERIFY2(m_window->text().contains(after), m_window->text().constData());
        QCOMPARE(m_window->document.edits().history().entries().size(), std::size_t(1));
        QVERIFY(!m_window->view().tools().gizmo().spot({GizmoHandle::Kind::Size, 2, 1, true})); // the layout is flat
        m_window->document.edits().undo();
        QCOMPARE(m_window->text(), text);
        QVERIFY(m_window->view().tools().gizmo().spot({GizmoHandle::Kind::Size, 0})); // of the first member
        m_window->trigger("tool.move");
        QVERIFY(!m_window->view().tools().gizmo().spot({GizmoHandle::Kind::Size, 0, 1, true}));
    }

    void paramsAreSizedWhateverTheirFormulaAndUnit_data() {
        QTest::addColumn<QByteArray>("config"); // of Thing; a drag makes it 0.2 m longer along its x axis
        QTest::addColumn<QByteArray>("own");    // values that the instance sets before
        QTest::addColumn<QByteArray>("after");
        QTest::newRow("centimetres") << QByteArray("Param long = 80 cm\nBox b { Size=$long,0.2,0.2 }") << QByteArray()
                                     << QByteArray("Pos=0.1,0,0.5 long=100 cm }");
        QTest::newRow("on the instance") << QByteArray("Param long = 1\nBox b { Size=$long,0.2,0.2 }")
                                         << QByteArray("long=800mm ") << QByteArray("Pos=0.1,0,0.5 long=1000mm }");
        QTest::newRow("half of it") << QByteArray("Param half = 0.4\nBox b { Size=$(2*half),0.2,0.2 }") << QByteArray()
                                    << QByteArray("Pos=0.1,0,0.5 half=0.5 }");
        QTest::newRow("a radius") << QByteArray("Param r = 0.4\nSphere s { Radius=$r }") << QByteArray()
                                  << QByteArray("Pos=0,0,0.5 r=0.6 }"); // the centre stays: the side moves by 0.2
        QTest::newRow("made of others") << QByteArray("Param high = 0.2\nParam long = $(4*high)\nBox b { Size=$long,0.2,$high }")
                                        << QByteArray() << QByteArray("Pos=0.1,0,0.5 long=1 }");
        QTest::newRow("of a formula with a unit") << QByteArray("Param base = 40 cm\nParam long = $(2*base)\n"
                                                                "Box b { Size=$long,0.2,0.2 }")
                                                  << QByteArray() << QByteArray("Pos=0.1,0,0.5 long=1 m }");
        QTest::newRow("a square") << QByteArray("Param area = 0.64\nBox b { Size=$(sqrt(area)),0.2,0.2 }") << QByteArray()
                                  << QByteArray("Pos=0.1,0,0.5 area=1 }");
        QTest::newRow("a turned shape") << QByteArray("Param long = 0.8\nCylinder c { Radius=0.1 Length=$long HPR=0,90,0 }")
                                        << QByteArray() << QByteArray("Pos=0.1,0,0.5 long=1 }");
    }
    void paramsAreSizedWhateverTheirFormulaAndUnit() {
        QFETCH(QByteArray, config);
        QFETCH(QByteArray, own);
        QFETCH(QByteArray, after);
        open("StaticConfig Thing {\n" + config +
             "\n}\nStatic other { Config=Thing Pos=9,9,0 }\n"
             "Static thing { Config=Thing Pos=0,0,0.5 " +
             own + "}\n");
        take("thing", "tool.scale");
        m_window->panel->settings().setSteps(0.1, 15);
        dragBy({GizmoHandle::Kind::Size, 0}, {0.2, 0, 0}, Qt::NoModifier, {0, 0, 0.5});
        QVERIFY2(m_window->text().contains("Static thing { Config=Thing " + after), m_window->text().constData());
        const StaticSpec& other = m_window->document.loaded()->experiment->statics.at(0);
        const StaticSpec& thing = m_window->document.loaded()->experiment->statics.at(1);
        const double grown = boundsOf(thing.geoms->at(0), Pose{}).size().x() - boundsOf(other.geoms->at(0), Pose{}).size().x();
        if (own.isEmpty()) QVERIFY(std::abs(grown - (config.contains("Sphere") ? 0.4 : 0.2)) < 1e-9);
    }

    void reportsMissingSizeParam() {
        open("StaticConfig Pair {\nParam a = 0.5\nParam b = 0.3\nParam high = 0.4\n"
             "Box box { Size=$(a+b),0.2,$high Pos=0,0,$(high/2) }\n}\nStatic pair { Config=Pair }\n");
        take("pair", "tool.scale");
        QVERIFY(!m_window->view().tools().gizmo().spot({GizmoHandle::Kind::Size, 0}));
        QVERIFY(!m_window->view().tools().gizmo().spot({GizmoHandle::Kind::Size, 1}));
        QVERIFY(m_window->view().tools().gizmo().spot({GizmoHandle::Kind::Size, 2}));
        const auto* banner = m_window->panel->findChild<QWidget*>(QStringLiteral("viewportBanner"));
        QVERIFY(banner->isVisible());
        const QString reportOf = banner->findChild<QLabel*>()->text();
        for (const char* word : {"pair", "along x it depends on a and b", "along y no Param sets it", "a, b, high"})
            QVERIFY2(reportOf.contains(QLatin1String(word)), qPrintable(reportOf));
    }

    void resizesSingleShapeWithoutParam() {
        open("StaticConfig Lump {\nBox lump { Size=0.4,0.4,0.4 Pos=0,0,0.2 }\n}\nStatic lump { Config=Lump }\n");
        take("lump", "tool.scale");
        dragBy({GizmoHandle::Kind::Size, 2}, {0, 0, 0.2}, Qt::NoModifier, {0, 0, 0.2});
        const GeomSpec& lump = m_window->document.loaded()->experiment->statics.at(0).geoms->at(0);
        QVERIFY2((lump.size - Vec3(0.4, 0.4, 0.6)).norm() < 1e-9, m_window->text().constData());
        QVERIFY((lump.pose.position - Vec3(0, 0, 0.3)).norm() < 1e-9);
    }

    /// The side that is dragged moves, along the shape's own axis, and the other stays.
    void eitherEndOfAShape_data() {
        QTest::addColumn<QByteArray>("shape");
        QTest::addColumn<int>("side");
        for (const char* shape :
             {"Box c { Size=0.2,0.2,0.4", "Cylinder c { Radius=0.1 Length=0.4", "Capsule c { Radius=0.1 Length=0.4"})
            for (const int side : {1, -1}) QTest::addRow("%.7s %d", shape, side) << QByteArray(shape) << side;
    }
    void eitherEndOfAShape() {
        QFETCH(QByteArray, shape);
        QFETCH(int, side);
        open("StaticConfig Lump {\n" + shape + " Pos=0,0,0.5 HPR=0,90,0 }\n}\nStatic lump { Config=Lump }\n");
        const auto geom = [&] { return m_window->document.loaded()->experiment->statics.at(0).geoms->at(0); };
        const Vec3 axis = geom().pose.rotation * Vec3::UnitZ(), end = geom().pose.position - 0.2 * side * axis;
        take("lump.c", "tool.scale");
        dragBy({GizmoHandle::Kind::Size, 2, side}, 0.2 * side * axis, Qt::NoModifier, {0, 0, 0.5});
        const double length = geom().shape == GeomShape::Box ? geom().size.z() : geom().length;
        QVERIFY2(std::abs(length - 0.6) < 1e-9, m_window->text().constData());
        QVERIFY2((geom().pose.position - 0.3 * side * axis - end).norm() < 1e-9, m_window->text().constData());
    }

    void robotsWithParamsAreSizedToo() {
        open("#import objects/crate.sim\n#import objects/barrel.sim\nRobot crate { Config=Crate Pos=0,0,0 }\n"
             "Robot barrel { Config=Barrel Pos=1,0,0 }\n");
        take("crate", "tool.scale");
        dragBy({GizmoHandle::Kind::Size, 2}, {0, 0, 0.15}, Qt::NoModifier, {0, 0, 0.125});
        QVERIFY2(m_window->text().contains("Pos=0,0,0 side=0.4 }"), m_window->text().constData());
        take("barrel", "tool.scale");
        dragBy({GizmoHandle::Kind::Size, 0}, {0.1, 0, 0}, Qt::NoModifier, {1, 0, 0.175});
        QVERIFY2(m_window->text().contains("Pos=1,0,0 radius=0.22 }"), m_window->text().constData()); // around its centre
    }

    /// As the Move tool does.
    void aReplacedFormulaIsNamed() {
        open("#import objects/crate.sim\nRobot crate { Config=Crate Pos=0,0,0 side=$(0.1+0.2) }\n");
        const QSignalSpy notices(&m_window->document, &Document::notice);
        take("crate", "tool.scale");
        dragBy({GizmoHandle::Kind::Size, 2}, {0, 0, 0.1}, Qt::NoModifier, {0, 0, 0.15});
        QVERIFY2(m_window->text().contains("side=0.4 }"), m_window->text().constData());
        QVERIFY(!notices.empty());
        QCOMPARE(notices.last().at(0).toString(), QStringLiteral("Replaced by numbers: $(0.1+0.2) in crate.side"));
    }

    void aRegionIsMovedAndSized() {
        open("Region goal { Pos=0,0,0.2 Size=0.6,0.4,0.2 }\n");
        take("goal", "tool.scale");
        dragBy({GizmoHandle::Kind::Size, 0}, {0.2, 0, 0}, Qt::NoModifier, {0, 0, 0.2});
        QVERIFY2(m_window->text().contains("{ Pos=0.1,0,0.2 Size=0.8,0.4,0.2 }"), m_window->text().constData());
        dragBy({GizmoHandle::Kind::Size, 2, -1}, {0, 0, -0.1}, Qt::NoModifier, {0.1, 0, 0.2});
        QVERIFY2(m_window->text().contains("{ Pos=0.1,0,0.15 Size=0.8,0.4,0.3 }"), m_window->text().constData());
        m_window->trigger("tool.move");
        dragBy({GizmoHandle::Kind::Axis, 1}, {0, 0.3, 0}, Qt::NoModifier, {0.1, 0, 0.15});
        QVERIFY2(m_window->text().contains("{ Pos=0.1,0.3,0.15 Size=0.8,0.4,0.3 }"), m_window->text().constData());
        QCOMPARE(m_window->document.edits().history().entries().size(), std::size_t(3));
    }

    /// All members of a Repeat have one text, in the frame of the member.
    void theRegionOfARepeatIsMovedInItsMembers() {
        open("Repeat gate {\n  Count=2 Pos=$(index),0,0 HPR=90,0,0\n  Region line { Pos=0,0,0.1 Size=0.4,0.1,0.2 }\n}\n");
        take("gate.line", "tool.move");
        dragBy({GizmoHandle::Kind::Axis, 1}, {0, 0.5, 0}, Qt::NoModifier, {0, 0, 0.1});
        QVERIFY2(m_window->text().contains("{ Pos=0.5,0,0.1 Size=0.4,0.1,0.2 }"), m_window->text().constData());
        QCOMPARE(m_window->document.loaded()->experiment->regions.size(), std::size_t(2));
    }

private:
    void open(const QByteArray& text) {
        QVERIFY(m_window->open(text));
        m_window->look({-0.2, -2.6, 2.2}, {-0.2, 0, 0});
        m_window->view().setFocus();
    }
    void take(const std::string& path, const char* tool) {
        m_window->selection.select(path);
        m_window->trigger(tool);
    }
    void dragBy(const GizmoHandle& handle, const Vec3& by, Qt::KeyboardModifiers modifiers, const Vec3& origin) {
        QVERIFY(dragHandle(*m_window, handle, by, origin, modifiers));
    }

    std::unique_ptr<RenderService> m_render;
    std::unique_ptr<ViewWindow> m_window;
};

QTEST_MAIN(ScaleTest)
#include "scale_test.moc"
