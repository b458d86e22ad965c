// The gizmo: moving, rotating and scaling objects by its handles.
#include <QtTest>

#include "editor/document/structure_edits.h"
#include "editor/viewport/gizmo_hand.h"

using namespace trundle;

namespace {

constexpr GizmoHandle kMoveX{GizmoHandle::Kind::Axis, 0}, kMoveZ{GizmoHandle::Kind::Axis, 2},
    kPlaneZ{GizmoHandle::Kind::Plane, 2}, kTurnZ{GizmoHandle::Kind::Ring, 2};

} // namespace

class GizmoTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_render = RenderService::startInBackground(); }

    void init() {
        m_window = std::make_unique<ViewWindow>(m_render.get());
        open(kRoom);
    }
    void cleanup() { m_window.reset(); }

    void aDragAlongAnAxisWritesTheExactNumberAndNothingElse() {
        take("robot0", "tool.move");
        dragBy(kMoveX, {0.35, 0, 0}, Qt::NoModifier);
        QByteArray expected = kRoom;
        QCOMPARE(m_window->text(), expected.replace("Pos=-0.5,0,0", "Pos=-0.15,0,0"));
        QCOMPARE(m_window->document.edits().history().entries().size(), std::size_t(1));
        QCOMPARE(m_window->document.edits().history().entries()[0].name, QStringLiteral("Move robot0"));
        m_window->document.edits().undo();
        QCOMPARE(m_window->text(), kRoom);
        m_window->document.edits().redo();
        QCOMPARE(m_window->text(), expected);
    }

    void withoutStepsANumberIsAsFineAsAPixel() {
        take("robot0", "tool.move");
        dragBy(kMoveX, {0.3333333, 0, 0}, Qt::ControlModifier);
        const QRegularExpression value(QStringLiteral("Pos=(-0\\.1\\d\\d?),0,0"));
        const auto match = value.match(QString::fromUtf8(m_window->text()));
        QVERIFY2(match.hasMatch(), m_window->text().constData());
        QVERIFY(std::abs(match.captured(1).toDouble() + 0.1666667) < 0.01);
    }

    void aPlaneMovesAlongTwoAxes() {
        take("robot0", "tool.move");
        dragBy(kPlaneZ, {0.2, -0.3, 0}, Qt::NoModifier);
        QVERIFY2(m_window->text().contains("Pos=-0.3,-0.3,0"), m_window->text().constData());
    }

    void turningWritesDegrees_data() {
        QTest::addColumn<QByteArray>("before");
        QTest::addColumn<QByteArray>("after");
        QTest::newRow("upright") << QByteArray("HPR=0,0,0") << QByteArray("HPR=45,0,0");
        QTest::newRow("pitch beyond 90 degrees") << QByteArray("HPR=0,170,0") << QByteArray("HPR=45,170,0");
        QTest::newRow("pitch of 90 degrees and a roll") << QByteArray("HPR=0,90,30") << QByteArray("HPR=45,90,30");
    }
    void turningWritesDegrees() {
        QFETCH(QByteArray, before);
        QFETCH(QByteArray, after);
        open(QByteArray(kRoom).replace("HPR=0,0,0 } // the first", before + " } // the first"));
        take("robot0", "tool.rotate");
        View& view = m_window->view();
        // From a point on the ring to the one 45 degrees further, seen from above.
        m_window->look({-0.5, -0.01, 4}, {-0.5, 0, 0});
        const double radius = 74 * view.camera().free().metresPerPixel(view.width(), {-0.5, 0, 0});
        const auto on = [&](double degrees) {
            const double a = degrees * M_PI / 180;
            return *view.camera().pixelOf(Vec3(-0.5, 0, 0) + radius * Vec3(std::cos(a), std::sin(a), 0));
        };
        QVERIFY(view.tools().gizmo().spot(kTurnZ));
        m_window->press(on(10));
        for (int i = 1; i <= 9; ++i) m_window->move(on(10 + 5 * i), {}, Qt::LeftButton);
        m_window->release(on(55));
        QVERIFY2(m_window->text().contains("Pos=-0.5,0,0 " + after + " } // the first"), m_window->text().constData());
        QCOMPARE(m_window->document.edits().history().entries().size(), std::size_t(1));
    }

    void escapeGivesTheSameBytes() {
        QVERIFY(m_window->document.structure().setValues(QStringLiteral("Set Tick"), {{"Tick", "0.02"}}).ok());
        m_window->document.edits().undo();
        take("robot0", "tool.move");
        const QPointF from = *m_window->view().tools().gizmo().spot(kMoveX);
        m_window->press(from);
        m_window->move(from + QPointF(120, 0), {}, Qt::LeftButton);
        QVERIFY(m_window->text() != kRoom);
        m_window->key(Qt::Key_Escape);
        QCOMPARE(m_window->text(), kRoom);
        QVERIFY(!m_window->document.edits().history().canUndo());
        QCOMPARE(m_window->document.edits().history().entries().size(), std::size_t(1)); // the redo entries are still available
        QCOMPARE(m_window->document.edits().history().entries()[0].name, QStringLiteral("Set Tick"));
        QVERIFY(!m_window->document.texts().isModified());
        m_window->move(from + QPointF(200, 0), {}, Qt::LeftButton);
        m_window->release(from + QPointF(200, 0));
        QCOMPARE(m_window->text(), kRoom);
        QCOMPARE(m_window->selection.current(), std::string("robot0"));
    }

    void aTypedNumberIsExact() {
        take("robot0", "tool.move");
        const QPointF from = *m_window->view().tools().gizmo().spot(kMoveX);
        m_window->press(from);
        m_window->move(from + QPointF(30, 4), {}, Qt::LeftButton);
        m_window->type(QStringLiteral("0.255"));
        m_window->key(Qt::Key_Backspace);
        m_window->key(Qt::Key_Return);
        QVERIFY2(m_window->text().contains("Pos=-0.25,0,0"), m_window->text().constData());
        m_window->move(from + QPointF(90, 4), {}, Qt::LeftButton); // the drag is cancelled, though the button is pressed
        m_window->release(from + QPointF(90, 4));
        QVERIFY(m_window->text().contains("Pos=-0.25,0,0"));
        QCOMPARE(m_window->document.edits().history().entries().size(), std::size_t(1));
    }

    /// Neither Enter nor the release of the mouse applies what the mouse has reached instead.
    void whatIsNoNumberIsNotApplied() {
        const QByteArray before = m_window->text();
        take("robot0", "tool.move");
        const QPointF from = *m_window->view().tools().gizmo().spot(kMoveX);
        m_window->press(from);
        m_window->move(from + QPointF(30, 4), {}, Qt::LeftButton);
        m_window->type(QStringLiteral("5 kg"));
        m_window->key(Qt::Key_Return);
        m_window->key(Qt::Key_Backspace);
        m_window->key(Qt::Key_Backspace);
        m_window->type(QStringLiteral("m")); // the drag continues
        QVERIFY2(m_window->text().contains("Pos=4.5,0,0"), m_window->text().constData());
        m_window->key(Qt::Key_Backspace);
        m_window->type(QStringLiteral("ft"));
        m_window->release(from);
        QCOMPARE(m_window->text(), before);
        QCOMPARE(m_window->refusals.size(), std::size_t(1));
        QVERIFY2(m_window->refusals[0].contains(QStringLiteral("ft")), qPrintable(m_window->refusals[0]));
    }

    void aTypedNumberMayCarryItsUnit() {
        take("robot0", "tool.move");
        const QPointF from = *m_window->view().tools().gizmo().spot(kMoveX);
        m_window->press(from);
        m_window->move(from + QPointF(30, 4), {}, Qt::LeftButton);
        m_window->type(QStringLiteral("25 c"));
        QVERIFY2(!m_window->text().contains("Pos=24.5"), m_window->text().constData()); // the unit is not metres
        m_window->type(QStringLiteral("m"));
        m_window->key(Qt::Key_Return);
        QVERIFY2(m_window->text().contains("Pos=-0.25,0,0"), m_window->text().constData());
        m_window->release(from);
    }

    void aTypedSizeIsTheSize() {
        open("StaticConfig Yard {\n  Cylinder drum { Radius=0.2 Length=0.4  Pos=0,0,0.2 }\n}\nStatic yard { Config=Yard }\n");
        take("StaticConfig.Yard.drum", "tool.scale");
        const auto type = [&](int axis, const char* typed) {
            const QPointF from = *m_window->view().tools().gizmo().spot({GizmoHandle::Kind::Size, axis});
            m_window->press(from);
            m_window->move(from + QPointF(12, 12), {}, Qt::LeftButton);
            m_window->type(QString::fromLatin1(typed));
            m_window->key(Qt::Key_Return);
            m_window->release(from);
        };
        type(2, "0.5");
        QVERIFY2(m_window->text().contains("Radius=0.2 Length=0.5 "), m_window->text().constData());
        type(0, "12 cm");
        QVERIFY2(m_window->text().contains("Radius=0.12 Length=0.5 "), m_window->text().constData());
    }

    void severalObjectsMoveTogether() {
        m_window->selection.set({"robot0", "robot1"});
        m_window->trigger("tool.move");
        dragBy(kMoveX, {-0.25, 0, 0}, Qt::NoModifier);
        QVERIFY(m_window->text().contains("Pos=-0.75,0,0") && m_window->text().contains("Pos=0.25,0.3,0"));
        QCOMPARE(m_window->document.edits().history().entries().size(), std::size_t(1));
        QCOMPARE(m_window->document.edits().history().entries()[0].name, QStringLiteral("Move 2 objects"));
    }

    void movesNestedSelectionOnce() {
        m_window->selection.set({"robot0.chassis.hull", "robot0"});
        m_window->trigger("tool.move");
        dragBy(kMoveX, {0.1, 0, 0}, Qt::NoModifier);
        QVERIFY(m_window->text().contains("Pos=-0.4,0,0"));
        QVERIFY(!m_window->text().contains("hull"));
    }

    void localAxesTurnWithTheObject() {
        open(QByteArray(kRoom).replace("HPR=0,0,0 } // the first", "HPR=90,0,0 } // the first"));
        take("robot0", "tool.move");
        m_window->panel->settings().setAxes(AxesOf::Local);
        // Its own x axis is the y axis of the world.
        dragBy(kMoveX, {0, 0.2, 0}, Qt::NoModifier);
        QVERIFY2(m_window->text().contains("Pos=-0.5,0.2,0"), m_window->text().constData());
    }

    void formulasThatDoNotChangeStay() {
        open("Param high = 0.25\n#import robots/simple_robot.sim\nRobot robot0 { Config=SimpleRobot  Pos = 10 cm, $(high * 2), "
             "$high }\n");
        take("robot0", "tool.move");
        dragBy(kMoveX, {0.2, 0, 0}, Qt::NoModifier);
        QVERIFY2(m_window->text().contains("Pos = 30 cm, $(high * 2), $high }"), m_window->text().constData());
        // One that changes becomes a number, which the status line says.
        const QSignalSpy notices(&m_window->document, &Document::notice);
        dragBy({GizmoHandle::Kind::Axis, 1}, {0, 0.1, 0}, Qt::NoModifier, {0.3, 0.5, 0.25});
        QVERIFY2(m_window->text().contains("Pos = 30 cm, 0.6, $high }"), m_window->text().constData());
        QVERIFY(!notices.empty());
        QCOMPARE(notices.last().at(0).toString(), QStringLiteral("Replaced by numbers: $(high * 2) in robot0.Pos"));
    }

    void overridesPartOfInstance() {
        m_window->look({-1.6, -2.2, 1.2}, {-0.3, 0, 0});
        take("robot0.chassis.bumper", "tool.move");
        dragBy(kMoveZ, {0, 0, 0.1}, Qt::NoModifier, {-0.34, 0, 0.07});
        QVERIFY2(m_window->text().contains("chassis.bumper.Pos"), m_window->text().constData());
        QVERIFY2(m_window->text().contains("0.16,0,0.17"), m_window->text().constData());
        m_window->document.edits().undo();
        QCOMPARE(m_window->text(), kRoom);
    }

    /// A Part moves in the frame of its config; what is in a mirrored Part moves with the mouse, its numbers the mirrored way.
    void aShapeIsSizedBySides() {
        open("StaticConfig Yard {\n  Box crate { Size=0.4, 0.4, 0.4  Pos=0,0,0.2 }\n}\nStatic yard { Config=Yard Pos=0,0,0 }\n");
        take("StaticConfig.Yard.crate", "tool.scale");
        const GizmoHandle side{GizmoHandle::Kind::Size, 0};
        QVERIFY(m_window->view().tools().gizmo().spot(side));
        dragBy(side, {0.1, 0, 0}, Qt::NoModifier, {0, 0, 0.2});
        QVERIFY2(m_window->text().contains("Size=0.5, 0.4, 0.4  Pos=0.05,0,0.2"), m_window->text().constData());
        // A side is dragged past the opposite side: the size stays positive and the opposite side stays in place.
        dragBy(side, {-9, 0, 0}, Qt::NoModifier, {0, 0, 0.2});
        QVERIFY2(m_window->text().contains("Size=0.001, 0.4, 0.4  Pos=-0.1995,0,0.2"), m_window->text().constData());
    }

    void aWallGrowsUpFromTheFloor() {
        const QByteArray walled =
            "Param high = 0.3\nStaticConfig Yard {\n  Box wall { Size=40 cm, 0.2, $high  Pos=$(high-0.3), 0, "
            "$(high/2) }\n}\nStatic yard { Config=Yard }\n";
        open(walled);
        take("StaticConfig.Yard.wall", "tool.scale");
        dragBy({GizmoHandle::Kind::Size, 2}, {0, 0, 0.2}, Qt::NoModifier, {0, 0, 0.15});
        QVERIFY2(m_window->text().contains("Size=40 cm, 0.2, 0.5  Pos=$(high-0.3), 0, 0.25 }"), m_window->text().constData());
        QCOMPARE(m_window->document.edits().history().entries().size(), std::size_t(1));
        m_window->document.edits().undo();
        QCOMPARE(m_window->text(), walled);
        // The handle at the other end moves the other side.
        take("StaticConfig.Yard.wall", "tool.scale");
        dragBy({GizmoHandle::Kind::Size, 0, -1}, {-0.1, 0, 0}, Qt::NoModifier, {0, 0, 0.15});
        QVERIFY2(m_window->text().contains("Size=50 cm, 0.2, $high  Pos=-0.05, 0, $(high/2) }"), m_window->text().constData());
    }

    void withoutStepsTheOtherSideStaysExactly() {
        open("StaticConfig Yard {\n  Box wall { Size=0.4, 0.4, 0.4  Pos=0,0,0.2 }\n}\nStatic yard { Config=Yard }\n");
        take("StaticConfig.Yard.wall", "tool.scale");
        dragBy({GizmoHandle::Kind::Size, 2}, {0, 0, 0.1234567}, Qt::ControlModifier, {0, 0, 0.2});
        const GeomSpec& wall = m_window->document.loaded()->experiment->statics.at(0).geoms->at(0);
        QVERIFY(wall.size.z() > 0.5 && wall.size.z() < 0.55);
        QVERIFY2(std::abs(wall.pose.position.z() - 0.5 * wall.size.z()) < 1e-12, m_window->text().constData());
    }

    void withAltTheMiddleStays() {
        open("StaticConfig Yard {\n  Box crate { Size=0.4, 0.4, 0.4  Pos=0,0,0.2 }\n}\nStatic yard { Config=Yard }\n");
        take("StaticConfig.Yard.crate", "tool.scale");
        const Vec3 middle(0, 0, 0.2);
        const QPointF from = *m_window->view().tools().gizmo().spot({GizmoHandle::Kind::Size, 0});
        const QPointF way =
            *m_window->view().camera().pixelOf(middle + Vec3(0.1, 0, 0)) - *m_window->view().camera().pixelOf(middle);
        m_window->press(from);
        m_window->move(from + way, {}, Qt::LeftButton);
        QVERIFY2(!m_window->text().contains("Pos=0,0,0.2"), m_window->text().constData());
        m_window->move(from + way, Qt::AltModifier, Qt::LeftButton);
        QTRY_VERIFY2(m_window->text().contains("Size=0.6, 0.4, 0.4  Pos=0,0,0.2"), m_window->text().constData());
        m_window->release(from + way, Qt::LeftButton, Qt::AltModifier);
        QVERIFY2(m_window->text().contains("Size=0.6, 0.4, 0.4  Pos=0,0,0.2"), m_window->text().constData());
        QCOMPARE(m_window->document.edits().history().entries().size(), std::size_t(1));
    }

    void aTurnedShapeGrowsAlongItsOwnAxis() {
        open("StaticConfig Yard {\n  Cylinder post { Radius=0.1 Length=0.4  Pos=0.2,0,0.3  HPR=90,90,0 }\n}\n"
             "Static yard { Config=Yard Pos=0,0,0 HPR=0,0,0 }\n");
        take("StaticConfig.Yard.post", "tool.scale");
        const GeomSpec before = m_window->document.loaded()->experiment->statics.at(0).geoms->at(0);
        const Vec3 axis = before.pose.rotation * Vec3::UnitZ();
        const GizmoHandle along{GizmoHandle::Kind::Size, 2};
        QVERIFY(std::abs(axis.z()) < 1e-9); // the axis is horizontal
        dragBy(along, 0.2 * axis, Qt::NoModifier, {0.2, 0, 0.3});
        const GeomSpec& after = m_window->document.loaded()->experiment->statics.at(0).geoms->at(0);
        QCOMPARE(after.length, 0.6);
        QCOMPARE(after.radius, 0.1);
        QVERIFY((after.pose.position - 0.3 * axis - (before.pose.position - 0.2 * axis)).norm() < 1e-6);
        // A radius has no opposite side.
        dragBy({GizmoHandle::Kind::Size, 0}, 0.1 * (before.pose.rotation * Vec3::UnitX()), Qt::NoModifier, after.pose.position);
        const GeomSpec& wide = m_window->document.loaded()->experiment->statics.at(0).geoms->at(0);
        QCOMPARE(wide.radius, 0.2);
        QCOMPARE(wide.pose.position, after.pose.position);
    }

    void arrowIsGrabbedByItsTip() {
        take("robot0", "tool.move");
        const QPointF middle = *m_window->view().camera().pixelOf({-0.5, 0, 0}),
                      spot = *m_window->view().tools().gizmo().spot(kMoveX);
        const QPointF along = (spot - middle) / QLineF(middle, spot).length();
        const QPointF tip = 2 * spot - middle - 11 * along; // outer end of the handle's line
        for (const double beyond : {4.0, 12.0}) {
            m_window->drag(tip + beyond * along, tip + 90 * along);
            QCOMPARE(m_window->document.edits().history().canUndo(), beyond < 7);
            m_window->document.edits().undo();
            take("robot0", "tool.move");
        }
    }

    void reportsThatRobotHasNoSize() {
        take("robot0", "tool.scale");
        const auto* banner = m_window->panel->findChild<QWidget*>(QStringLiteral("viewportBanner"));
        QVERIFY(banner->isVisible());
        m_window->selection.select("robot0.chassis.hull");
        QVERIFY(!banner->isVisible());
    }

    void aMemberOfAGridOffersToBeReplaced() {
        open("#import robots/simple_robot.sim\nGrid swarm { Config=SimpleRobot Pos=0,0,0 Count=2 Spacing=1 }\n");
        take("swarm_1", "tool.move");
        QVERIFY(!m_window->view().tools().gizmo().spot(kMoveX));
        auto* button = m_window->panel->findChild<QWidget*>(QStringLiteral("bannerButton"));
        QVERIFY(button->isVisible());
        QTest::mouseClick(button, Qt::LeftButton);
        QVERIFY2(!m_window->text().contains("Grid") && m_window->text().contains("Robot swarm_1"), m_window->text().constData());
        take("swarm_1", "tool.move");
        QVERIFY(m_window->view().tools().gizmo().spot(kMoveX));
        m_window->document.edits().undo();
        QVERIFY(m_window->text().contains("Grid swarm { Config=SimpleRobot Pos=0,0,0 Count=2 Spacing=1 }"));
    }

    void aWholeGridIsMoved() {
        open("#import robots/simple_robot.sim\nGrid swarm { Config=SimpleRobot Pos=0.1,0,0 Count=2 Spacing=1 }\n");
        take("swarm", "tool.move");
        dragBy(kMoveX, {0.5, 0, 0}, Qt::NoModifier, {0.1, 0, 0});
        QVERIFY2(m_window->text().contains("Pos=0.6,0,0 Count=2"), m_window->text().constData());
    }

    void arrowKeysNudgeByTheStep() {
        m_window->selection.select("robot0");
        m_window->key(Qt::Key_Right);
        m_window->key(Qt::Key_Right);
        m_window->key(Qt::Key_Up);
        m_window->key(Qt::Key_PageUp);
        QVERIFY2(m_window->text().contains("Pos=-0.4,0.05,0.05"), m_window->text().constData());
        m_window->key(Qt::Key_Right, Qt::ShiftModifier); // ten steps
        m_window->key(Qt::Key_PageUp, Qt::ShiftModifier);
        QVERIFY2(m_window->text().contains("Pos=0.1,0.05,0.55"), m_window->text().constData());
        QCOMPARE(m_window->document.edits().history().entries().size(), std::size_t(1));
        m_window->document.edits().undo();
        QCOMPARE(m_window->text(), kRoom);
    }

    void aRefusedDragLeavesTheText() {
        open(QByteArray(kRoom) + "Robot broken { Config=Nothing Pos=1,1,0 }\n");
        const QByteArray before = m_window->text();
        take("broken", "tool.move");
        QVERIFY(!m_window->view().tools().gizmo().spot(kMoveX)); // the gizmo is not drawn
        take("robot0", "tool.move");
        dragBy(kMoveX, {0.1, 0, 0}, Qt::NoModifier);
        QVERIFY2(m_window->text().contains("Pos=-0.4,0,0"), m_window->text().constData());
        m_window->document.edits().undo();
        QCOMPARE(m_window->text(), before);
    }

    void losingMouseEndsDrag() {
        take("robot0", "tool.move");
        const QPointF from = *m_window->view().tools().gizmo().spot(kMoveX);
        m_window->press(from);
        m_window->move(from + QPointF(100, 0), {}, Qt::LeftButton);
        QVERIFY(m_window->open("Tick = 0.02\n")); // opens another document during the drag
        m_window->move(from + QPointF(150, 0), {}, Qt::LeftButton);
        m_window->release(from + QPointF(150, 0));
        QCOMPARE(m_window->text(), QByteArray("Tick = 0.02\n"));
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
    /// Drags a handle at `origin` (in W) by `by`.
    void dragBy(const GizmoHandle& handle, const Vec3& by, Qt::KeyboardModifiers modifiers, Vec3 origin = {-0.5, 0, 0}) {
        QVERIFY(dragHandle(*m_window, handle, by, origin, modifiers));
    }

    std::unique_ptr<RenderService> m_render;
    std::unique_ptr<ViewWindow> m_window;
};

QTEST_MAIN(GizmoTest)
#include "gizmo_test.moc"
