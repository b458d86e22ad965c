// The handles of joints, their sliders, and joining bodies by a drag.
#include <QSlider>
#include <QtTest>

#include "editor/viewport/gizmo/aim_shape.h"
#include "editor/viewport/gizmo/aim_tool.h"
#include "editor/viewport/gizmo/joint_tool.h"
#include "editor/viewport/view_window.h"
#include "eventually.h"
#include "lang/formatter.h"

using namespace trundle;

namespace {

const QByteArray kArm = R"(RobotConfig Arm {
  Body post { Box column { Size=0.1,0.1,0.4 Pos=0,0,0.2 Mass=5 } }
  Body link {
    Pos=0.2,0,0.4
    Box beam { Size=0.4,0.05,0.05 Mass=1 }
  }
  Body tip { Pos=0.45,0,0.4  Box block { Size=0.06,0.06,0.06 Mass=0.1 } }
  Body wheel { Pos=0,0.3,0.05  Cylinder tyre { Radius=0.05 Length=0.03 HPR=0,0,90 Mass=0.15 } }
  Fixed foot { Parent=world Child=post }
  Hinge elbow { Parent=post Child=link Anchor=0,0,0.4 Axis=0,1,0 HighStop=90 }
  Slider reach { Parent=link Child=tip Axis=1,0,0 LowStop=0 HighStop=0.1 }
  Camera eye { Body=tip Pos=0.03,0,0 }
}
Robot arm { Config=Arm }
)";

constexpr JointHandle kAnchor{JointHandle::Kind::Anchor, {}}, kAxis{JointHandle::Kind::Axis, {}},
    kSwing{JointHandle::Kind::Swing, {}}, kTravelUp{JointHandle::Kind::Travel, {true, false}},
    kLow{JointHandle::Kind::Stop, {false, false}}, kHigh{JointHandle::Kind::Stop, {true, false}};

} // namespace

class JointsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_render = RenderService::startInBackground(); }
    void init() {
        m_window = std::make_unique<ViewWindow>(m_render.get());
        QVERIFY(m_window->open(kArm));
        m_window->look({0.3, -1.6, 0.5}, {0.2, 0, 0.35}); // x to the right, z up
    }
    void cleanup() { m_window.reset(); }

    void anchorIsDraggedInOneEdit() {
        m_window->selection.select("arm.elbow");
        dragTo(kAnchor, {0.1, 0, 0.3}); // two steps of 5 cm to each side; y stays
        QCOMPARE(m_window->text(), replaced("Anchor=0,0,0.4", "Anchor=0.1,0,0.3"));
        QCOMPARE(m_window->document.edits().history().entries().size(), std::size_t(1));
        m_window->document.edits().undo();
        QCOMPARE(m_window->text(), kArm);
    }

    void anchorSnapsToCentresOfTheBodies() {
        m_window->selection.select("RobotConfig.Arm.elbow");
        dragTo(kAnchor, {0.201, 0, 0.402});
        QCOMPARE(m_window->text(), replaced("Anchor=0,0,0.4", "Anchor=0.2,0,0.4"));
    }

    void axisTurnsToTheNearestMainAxis() {
        m_window->look({1.2, -1.2, 1.2}, {0, 0, 0.4});
        m_window->selection.select("arm.elbow");
        const double length = arrow({0, 0, 0.4});
        dragTo(kAxis, Vec3(0, 0, 0.4) + length * Vec3(0.08, 0.05, 0.99));
        QCOMPARE(m_window->text(), replaced("Axis=0,1,0 High", "Axis=0,0,1 High"));
        QCOMPARE(m_window->document.edits().history().entries().size(), std::size_t(1));
    }

    void doubleClickReversesTheAxis() {
        m_window->look({1.2, -1.2, 1.2}, {0, 0, 0.4});
        m_window->selection.select("arm.elbow");
        const QPointF at = *tool().spot(kAxis);
        m_window->click(at);
        QMouseEvent twice(QEvent::MouseButtonDblClick, at, m_window->view().mapToGlobal(at), Qt::LeftButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&m_window->view(), &twice);
        m_window->release(at);
        QCOMPARE(m_window->text(), replaced("Axis=0,1,0 High", "Axis=0,-1,0 High"));
    }

    /// Axis2 changes only where the new axis is not at a right angle to it, and by the end of a drag it is that of the start again.
    void secondAxisStaysWhereItIsSquare() {
        const QByteArray axes = "Universal elbow { Parent=post Child=link Anchor=0,0,0.4 Axis=0,1,0 Axis2=1,0,0 }";
        const QByteArray text =
            replaced("Hinge elbow { Parent=post Child=link Anchor=0,0,0.4 Axis=0,1,0 HighStop=90 }", axes.constData());
        QVERIFY(m_window->open(text));
        m_window->selection.select("RobotConfig.Arm.elbow");
        std::optional<EditedJoint> joint = EditedJoint::selected(m_window->view().context());
        QVERIFY(joint);
        QVERIFY(joint->setAxis(m_window->document, -joint->axis(false), false, {}));
        QCOMPARE(m_window->text(), QByteArray(text).replace("Axis=0,1,0 ", "Axis=0,-1,0 "));
        m_window->document.edits().undo();
        QVERIFY(joint->setAxis(m_window->document, {1, 0, 0}, false, "drag"));
        QCOMPARE(m_window->text(), QByteArray(text).replace("Axis=0,1,0 Axis2=1,0,0", "Axis=1,0,0 Axis2=0,-1,0"));
        QVERIFY(joint->setAxis(m_window->document, {0, 0, 1}, false, "drag"));
        QCOMPARE(m_window->text(), QByteArray(text).replace("Axis=0,1,0 ", "Axis=0,0,1 "));
    }

    void stopsAreDraggedOnTheirArc() {
        m_window->selection.select("arm.elbow");
        dragTo(kHigh, onArc(45));
        QCOMPARE(m_window->text(), replaced("HighStop=90", "HighStop=45"));
        dragTo(kLow, onArc(-30)); // there was none
        QCOMPARE(m_window->text(), replaced("HighStop=90", "HighStop=45 LowStop=-30"));
        dragTo(kLow, onArc(80)); // it stays below the other one
        QCOMPARE(m_window->text(), replaced("HighStop=90", "HighStop=45 LowStop=45"));
        QVERIFY(m_window->refusals.empty());
    }

    void stopsOfASliderAreOnItsLine() {
        m_window->selection.select("arm.reach");
        const Vec3 anchor(0.45, 0, 0.4);
        dragTo(kHigh, anchor + Vec3(0.15, 0, 0));
        QCOMPARE(m_window->text(), replaced("HighStop=0.1 ", "HighStop=0.15 "));
        QVERIFY(!tool().spot(kAnchor)); // it makes no difference
    }

    void swingOfABallIsDraggedOnItsCone() {
        QVERIFY(m_window->open(
            QByteArray(kArm).replace("Hinge elbow { Parent=post Child=link Anchor=0,0,0.4 Axis=0,1,0 HighStop=90 }",
                                     "Ball elbow { Parent=post Child=link Anchor=0,0,0.4 Axis=0,0,1 }")));
        const QByteArray before = m_window->text();
        m_window->selection.select("arm.elbow");
        const double reach = JointHandles::kCirclePart * arrow({0, 0, 0.4}), angle = 40 * M_PI / 180;
        dragTo(kSwing, Vec3(0, 0, 0.4) + reach * Vec3(std::sin(angle), 0, std::cos(angle)));
        QCOMPARE(m_window->text(), QByteArray(before).replace("Axis=0,0,1 }", "Axis=0,0,1 SwingStop=40 }"));
        QCOMPARE(m_window->document.edits().history().entries().size(), std::size_t(1));
        m_window->document.edits().undo();
        QCOMPARE(m_window->text(), before);
    }

    void travelOfASuspensionIsDraggedAlongItsAxis() {
        QVERIFY(m_window->open(QByteArray(kArm).replace(
            "Slider reach { Parent=link Child=tip Axis=1,0,0 LowStop=0 HighStop=0.1 }",
            "Suspension reach { Parent=link Child=tip Axis=0,0,1 Axis2=0,1,0 Stiffness=100 Travel=2cm }")));
        const QByteArray before = m_window->text();
        m_window->selection.select("RobotConfig.Arm.reach");
        dragTo(kTravelUp, Vec3(0.45, 0, 0.4 + 0.05));
        QVERIFY2(m_window->text().contains("Travel=5cm") || m_window->text().contains("Travel=5 cm"),
                 m_window->text().constData());
        dragTo({JointHandle::Kind::Travel, {false, false}}, Vec3(0.45, 0, 0.4 - 0.03));
        QVERIFY2(m_window->text().contains("Travel=3cm") || m_window->text().contains("Travel=3 cm"),
                 m_window->text().constData());
        m_window->document.edits().undo();
        m_window->document.edits().undo();
        QCOMPARE(m_window->text(), before);
    }

    void escapeRestoresTheText() {
        m_window->selection.select("arm.elbow");
        const QPointF from = *tool().spot(kAnchor);
        m_window->press(from);
        m_window->move(from + QPointF(80, 20), {}, Qt::LeftButton);
        QVERIFY(m_window->text() != kArm);
        m_window->key(Qt::Key_Escape);
        QCOMPARE(m_window->text(), kArm);
        QVERIFY(!m_window->document.edits().history().canUndo());
        m_window->release(from);
    }

    void aDeviceShowsItsJoint() {
        QVERIFY(m_window->open(
            QByteArray(kArm).replace("  Camera", "  Servo drive { Joint=elbow MaxTorque=1 MaxSpeed=1 }\n  Camera")));
        m_window->selection.select("arm.drive");
        QVERIFY(tool().spot(kAnchor));
        m_window->selection.select("arm.link");
        QVERIFY(!tool().spot(kAnchor));
    }

    void slidersPoseTheTreeOfBodies() {
        m_window->trigger("model.joints");
        auto* elbow = m_window->panel->findChild<QSlider*>(QStringLiteral("joint.elbow.0"));
        auto* reach = m_window->panel->findChild<QSlider*>(QStringLiteral("joint.reach.0"));
        QVERIFY(elbow && reach && elbow->isVisible());
        QCOMPARE(reach->maximum(), 1000); // a tenth of a millimetre
        elbow->setFocus();
        QTest::keyClick(elbow, Qt::Key_End); // 90 degrees about y: x points down
        QVERIFY(at("arm.tip").isApprox(Vec3(0, 0, 0.4 - 0.45), 1e-9));
        reach->setFocus();
        QTest::keyClick(reach, Qt::Key_End);
        QVERIFY(at("arm.tip").isApprox(Vec3(0, 0, 0.4 - 0.55), 1e-9));
        QVERIFY(at("arm.link").isApprox(Vec3(0, 0, 0.2), 1e-9));
        QVERIFY(at("arm.post").isZero(1e-12));
        QCOMPARE(m_window->text(), kArm);
        QTest::mouseClick(m_window->panel->findChild<QWidget*>(QStringLiteral("jointsReset")), Qt::LeftButton);
        QVERIFY(at("arm.tip").isApprox(Vec3(0.45, 0, 0.4), 1e-12));
        QCOMPARE(elbow->value(), 0);
    }

    void whatAJointHasMovedIsMovedAsItIsShown() {
        m_window->trigger("model.joints");
        auto* elbow = m_window->panel->findChild<QSlider*>(QStringLiteral("joint.elbow.0"));
        elbow->setFocus();
        QTest::keyClick(elbow, Qt::Key_End);
        m_window->selection.select("RobotConfig.Arm.link");
        m_window->trigger("tool.move");
        m_window->key(Qt::Key_Right); // along x of the world, which is up in the frame of the link
        QVERIFY2(m_window->text().contains("Pos=0.2,0,0.45"), m_window->text().constData());
        QVERIFY(at("arm.link").isApprox(Vec3(0.05, 0, 0.2), 1e-9));
    }

    void aWheelIsConnectedAboutItsAxle() {
        m_window->look({-1, 1.4, 0.8}, {0, 0.1, 0.2});
        m_window->trigger("tool.connectHinge");
        m_window->drag(m_window->at({0, 0.05, 0.2}), m_window->at({0, 0.315, 0.05}));
        QVERIFY2(m_window->text().contains("\n  Hinge axle { Parent=post Child=wheel Axis=0,1,0 }\n"),
                 m_window->text().constData());
        QVERIFY2(m_window->selection.current().ends_with(".axle"), m_window->selection.current().c_str());
        QCOMPARE(m_window->document.edits().history().entries().size(), std::size_t(1));
        QVERIFY(m_window->document.loaded()->experiment);
        QVERIFY(tool().spot(kAnchor)); // its handles are there at once
        QVERIFY(isClean());
        m_window->document.edits().undo();
        QCOMPARE(m_window->text(), kArm);
    }

    void otherBodiesAreConnectedWhereTheyArePicked() {
        QVERIFY(m_window->open(
            QByteArray(kArm).replace("  Hinge elbow { Parent=post Child=link Anchor=0,0,0.4 Axis=0,1,0 HighStop=90 }\n", "")));
        m_window->trigger("tool.connectHinge");
        m_window->drag(m_window->at({0, -0.05, 0.2}), m_window->at({0.12, -0.025, 0.4}));
        QVERIFY2(m_window->text().contains("Hinge linkHinge { Parent=post Child=link Anchor=0.12,-0.025,0.4 Axis=0,1,0 }"),
                 m_window->text().constData());
        m_window->trigger("tool.connectSlider");
        m_window->drag(m_window->at({0.12, -0.025, 0.4}), m_window->at({0.45, -0.03, 0.4}));
        QCOMPARE(m_window->refusals.size(), std::size_t(1)); // they are joined already
        QVERIFY(m_window->refusals[0].contains(QStringLiteral("reach")));
    }

    void cameraIsAimedByItsSight() {
        m_window->look({0.45, -0.01, 2.5}, {0.45, 0, 0.4}); // from above
        m_window->selection.select("arm.eye");
        const Vec3 eye(0.48, 0, 0.4);
        const QPointF from = *m_window->view().tools().aim().spot();
        const Vec3 along(std::cos(M_PI / 6), std::sin(M_PI / 6), 0);
        const double reach = QLineF(m_window->at(eye), from).length();
        const Vec3 there = eye + along;
        const QPointF way = QPointF(m_window->at(there)) - QPointF(m_window->at(eye));
        m_window->drag(from, QPointF(m_window->at(eye)) + way * (reach / std::hypot(way.x(), way.y())));
        QCOMPARE(m_window->text(), replaced("Pos=0.03,0,0 }", "Pos=0.03,0,0 HPR=30,0,0 }"));
        QCOMPARE(m_window->document.edits().history().entries().size(), std::size_t(1));
        m_window->document.edits().undo();
        QCOMPARE(m_window->text(), kArm);
    }

    /// Through one robot of two: the HPR of their config is another one.
    void cameraIsAimedBackToZero() {
        const QByteArray text =
            replaced("Pos=0.03,0,0 }", "Pos=0.03,0,0 HPR=180,0,0 }") + "Robot other { Config=Arm Pos=9,9,0 }\n";
        QVERIFY(m_window->open(text));
        m_window->look({0.45, -0.01, 2.5}, {0.45, 0, 0.4}); // from above
        m_window->selection.select("arm.eye");
        const QPointF from = *m_window->view().tools().aim().spot(), at = m_window->at({0.48, 0, 0.4});
        const QPointF way = QPointF(m_window->at({1.48, 0, 0.4})) - at;
        m_window->drag(from, at + way * (QLineF(at, from).length() / std::hypot(way.x(), way.y())));
        QCOMPARE(m_window->text(), QByteArray(text).replace("{ Config=Arm }", "{ Config=Arm eye.HPR=0,0,0 }"));
    }

    void devicesAreAimedByTheirShape_data() {
        QTest::addColumn<QByteArray>("device");
        QTest::newRow("frustum of a camera") << QByteArray("Camera eye { Body=tip Pos=0.03,0,0 }");
        QTest::newRow("fan of a lidar") << QByteArray("Lidar eye { Body=tip Pos=0.03,0,0 FieldOfView=90 Beams=31 MaxRange=0.8 }");
        QTest::newRow("cone of a sonar") << QByteArray(
            "RangeSensor eye { Body=tip Pos=0.03,0,0 Type=ultrasonic ConeAngle=30 MaxRange=0.8 }");
        QTest::newRow("lobe of an antenna") << QByteArray("Transceiver eye { Body=tip Pos=0.03,0,0 Antenna=beam }");
    }
    /// By an edge of its frustum, fan, cone or lobe, which stays under the mouse.
    void devicesAreAimedByTheirShape() {
        QFETCH(QByteArray, device);
        const QByteArray before = "AntennaPattern beam { Model=patch BeamWidth=60 }\n" +
                                  QByteArray(kArm).replace("Camera eye { Body=tip Pos=0.03,0,0 }", device);
        QVERIFY(m_window->open(before));
        m_window->look({0.45, -0.01, 3.5}, {0.45, 0, 0.4}); // from above
        m_window->selection.select("arm.eye");
        if (device.startsWith("Transceiver")) m_window->trigger("view.overlayLobes"); // a lobe is held where it is shown
        EVENTUALLY(!aimShapeOf(m_window->view(), "arm.eye").empty());
        const Vec3 eye(0.48, 0, 0.4);
        Vec3 held = eye; // a point of a line beside the line of sight, away from its handle
        for (const auto& [from, to] : aimShapeOf(m_window->view(), "arm.eye"))
            for (double part = 0.001; part < 1; part *= 1.4) {
                const Vec3 point = from + part * (to - from), out = point - eye;
                if (std::abs(out.y()) > 0.1 * out.norm() && out.norm() < 0.7 && out.norm() > (held - eye).norm()) held = point;
            }
        QVERIFY((held - eye).norm() > 0.05);
        const Vec3 turned = eye + Quat(Eigen::AngleAxisd(M_PI / 4, Vec3::UnitZ())) * (held - eye);
        m_window->drag(m_window->at(held), m_window->at(turned));
        QByteArray aimed = m_window->text();
        QVERIFY2(aimed.contains(" HPR=45,0,0"), aimed.constData());
        QCOMPARE(aimed.replace(" HPR=45,0,0", ""), before);
        QCOMPARE(m_window->document.edits().history().entries().size(), std::size_t(1));
        m_window->document.edits().undo();
        QCOMPARE(m_window->text(), before);
    }

    void cameraIsRolledAboutItsSight() {
        m_window->look({2.4, 0, 0.4}, {0.45, 0, 0.4}); // from ahead
        m_window->selection.select("arm.eye");
        const auto from = m_window->view().tools().aim().rollSpot();
        QVERIFY(from);
        const QPointF centre = m_window->at({0.5, 0, 0.4}), up = *from - centre;
        m_window->drag(*from, centre + std::hypot(up.x(), up.y()) * QPointF(1, 0)); // a quarter turn
        QVERIFY2(m_window->text().contains("HPR=0,0,90") || m_window->text().contains("HPR=0,0,-90"),
                 m_window->text().constData());
        QCOMPARE(m_window->document.edits().history().entries().size(), std::size_t(1));
        m_window->document.edits().undo();
        QCOMPARE(m_window->text(), kArm);
    }

    /// Its heading turns about the line of sight as its roll does.
    void cameraThatLooksDownIsRolled() {
        QVERIFY(m_window->open(replaced("Pos=0.03,0,0 }", "Pos=0.03,0,0 HPR=0,90,0 }")));
        m_window->look({0.48, -0.01, 2.5}, {0.48, 0, 0.4}); // from above
        m_window->selection.select("RobotConfig.Arm.eye");
        const auto from = m_window->view().tools().aim().rollSpot();
        QVERIFY(from);
        const QPointF centre = m_window->at({0.48, 0, 0.4}), up = *from - centre;
        m_window->drag(*from, centre + QPointF(-up.y(), up.x())); // a quarter turn
        QVERIFY2(m_window->text().contains("HPR=90,90,0") || m_window->text().contains("HPR=-90,90,0"),
                 m_window->text().constData());
    }

    /// With its pitch beyond 90 degrees, which stays.
    void cameraThatIsUpsideDownIsAimed() {
        QVERIFY(m_window->open(replaced("Pos=0.03,0,0 }", "Pos=0.03,0,0 HPR=0,180,0 }")));
        m_window->look({0.45, -0.01, 2.5}, {0.45, 0, 0.4}); // from above
        m_window->selection.select("RobotConfig.Arm.eye");
        const QPointF at = m_window->at({0.48, 0, 0.4}), from = *m_window->view().tools().aim().spot();
        const QPointF way = QPointF(m_window->at(Vec3(0.48, 0, 0.4) - Vec3(std::cos(M_PI / 6), std::sin(M_PI / 6), 0))) - at;
        m_window->drag(from, at + way * (QLineF(at, from).length() / std::hypot(way.x(), way.y())));
        QCOMPARE(m_window->text(), replaced("Pos=0.03,0,0 }", "Pos=0.03,0,0 HPR=30,180,0 }"));
    }

    /// In the text of a config all members of a Repeat are one: the handles are at the first one, what they write is for all.
    void jointsOfARepeatAreEditedAtTheFirst() {
        const QByteArray text = kArm +
                                "RobotConfig Cart { Body base { Box hull { Size=0.4,0.3,0.06 Pos=0,0,0.1 Mass=2 } }\n"
                                "  Repeat leg { Count=2\n"
                                "    Body w { Pos=$(0.3*index - 0.15),0.2,0.1 Sphere c { Radius=0.1 Mass=0.3 } }\n"
                                "    Hinge axle { Parent=base Child=w Anchor=$(0.3*index - 0.15),0.17,0.1 Axis=0,1,0 } } }\n"
                                "Robot one { Config=Cart Pos=0,2,0 }\nRobot two { Config=Cart Pos=0,4,0 }\n";
        QVERIFY(m_window->open(text));
        const auto moved = [&](const char* path) {
            m_window->selection.select(path);
            const std::optional<EditedJoint> joint = EditedJoint::selected(m_window->view().context());
            if (!joint) return QByteArray("no joint");
            (void)joint->setAnchor(m_window->document, joint->spec().anchor + Vec3(0.05, 0.01, 0), 1e-4, {});
            const QByteArray after = m_window->text();
            m_window->document.edits().undo();
            return after;
        };
        const QByteArray all = QByteArray(text).replace("Anchor=$(0.3*index - 0.15),0.17,", "Anchor=$(0.3*index - 0.1),0.18,");
        QCOMPARE(moved("RobotConfig.Cart.leg.axle"), all);
        QCOMPARE(moved("RobotConfig.Cart.leg_1.axle"), all);
        QCOMPARE(moved("two.leg_1.axle"), QByteArray(text).replace("Pos=0,4,0 }", "Pos=0,4,0 leg_1.axle.Anchor=0.2,0.18,0.1 }"));
        QCOMPARE(moved("two.leg.axle"), QByteArray(text).replace("Pos=0,4,0 }", "Pos=0,4,0 leg_0.axle.Anchor=-0.1,0.18,0.1 }"));
        QVERIFY(m_window->open(
            QByteArray(kArm)
                .replace("  Slider reach", "  Slider elbow_1")
                .replace("  Hinge elbow",
                         "  Hinge elbow_0 { Parent=post Child=wheel }\n  Hinge elbow"))); // names alike, and no Repeat
        m_window->selection.select("RobotConfig.Arm.elbow");
        QCOMPARE(EditedJoint::selected(m_window->view().context())->spec().name, std::string("elbow"));
        QVERIFY(isNameOf("row_3.eye", "row.eye") && !isNameOf("eye_1", "eye") && isNameOf("eye_1", "eye_1"));
        QVERIFY(m_window->open(text));
        m_window->selection.select("RobotConfig.Cart.leg.axle");
        QVERIFY(tool().spot(kAnchor) && tool().spot(kAxis));
    }

    /// A device in a Ring is aimed in the frame of its member: all of them pitch by the same angle.
    void devicesOfARingAreAimed_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<Vec3>("out");
        QTest::newRow("all") << "RobotConfig.Arm.eyes.eye" << Vec3(1, 0, 0);
        QTest::newRow("the first") << "RobotConfig.Arm.eyes_0.eye" << Vec3(1, 0, 0);
        QTest::newRow("the second") << "RobotConfig.Arm.eyes_1.eye" << Vec3(0, 1, 0);
    }
    void devicesOfARingAreAimed() {
        QFETCH(QString, path);
        QFETCH(Vec3, out);
        const QByteArray text = QByteArray(kArm).replace(
            "  Camera eye", "  Ring eyes { Count=4 Radius=0.2 Pos=0,0,0.3\n"
                            "    RangeSensor eye { Body=post Type=ultrasonic ConeAngle=30 MaxRange=0.8 } }\n  Camera eye");
        QVERIFY(m_window->open(text));
        const Vec3 eye = Vec3(0, 0, 0.3) + 0.2 * out, side = out.cross(Vec3::UnitZ());
        m_window->look(eye + 0.5 * out + 3 * side, eye + 0.5 * out); // from its side
        m_window->selection.select(path.toStdString());
        const auto from = m_window->view().tools().aim().spot();
        QVERIFY(from);
        QVERIFY(!aimShapeOf(m_window->view(), path.toStdString()).empty());
        const Vec3 there = eye + std::cos(M_PI / 6) * out - std::sin(M_PI / 6) * Vec3::UnitZ(); // 30 degrees down
        const QPointF at = m_window->at(eye), way = QPointF(m_window->at(there)) - at;
        m_window->drag(*from, at + way * (QLineF(at, *from).length() / std::hypot(way.x(), way.y())));
        QCOMPARE(m_window->text(), QByteArray(text).replace("MaxRange=0.8 }", "MaxRange=0.8 HPR=0,30,0 }"));
        m_window->document.edits().undo();
        QCOMPARE(m_window->text(), text);
    }

private:
    JointTool& tool() { return m_window->view().tools().joint(); }
    QByteArray replaced(const char* before, const char* after) const { return QByteArray(kArm).replace(before, after); }
    void dragTo(const JointHandle& handle, const Vec3& point) {
        const auto from = tool().spot(handle);
        QVERIFY(from);
        m_window->drag(*from, m_window->view().camera().pixelOf(point).value());
    }
    /// m, of the arrow of an axis there.
    double arrow(const Vec3& p) { return 88 * m_window->view().camera().free().metresPerPixel(m_window->view().width(), p); }
    /// On the arc of the elbow, whose angle 0 is along x and grows downwards.
    static Vec3 onArc(double degrees) {
        const double a = degrees * M_PI / 180;
        return Vec3(0, 0, 0.4) + 0.12 * Vec3(std::cos(a), 0, -std::sin(a));
    }
    Vec3 at(const char* path) {
        const ViewportScene& world = m_window->panel->world();
        return world.poseOf(*world.find(path)).position;
    }
    bool isClean() const { return format(*m_window->document.loaded()->trees[0]) == m_window->text().toStdString(); }

    std::unique_ptr<RenderService> m_render;
    std::unique_ptr<ViewWindow> m_window;
};

QTEST_MAIN(JointsTest)
#include "joints_test.moc"
