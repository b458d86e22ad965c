// The gizmo on what Parts, Repeats and In place: numbers are in the frame in which they are written.
#include <QLabel>
#include <QtTest>

#include "editor/viewport/gizmo/aim_tool.h"
#include "editor/viewport/gizmo/joint_tool.h"
#include "editor/viewport/gizmo/transform_selection.h"
#include "editor/viewport/gizmo_hand.h"

using namespace trundle;

namespace {

constexpr GizmoHandle kMoveZ{GizmoHandle::Kind::Axis, 2};
constexpr JointHandle kAnchor{JointHandle::Kind::Anchor, {}};

} // namespace

class MovePartsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_render = RenderService::startInBackground(); }
    void init() { m_window = std::make_unique<ViewWindow>(m_render.get()); }
    void cleanup() { m_window.reset(); }

    void partsMove() {
        const QByteArray text = "PartConfig Wheel { Body wheel { Box tyre { Size=0.2,0.2,0.2 Mass=1 } } }\n"
                                "RobotConfig Kit { Body chassis { Box hull { Size=0.1,0.1,0.1 Mass=1 } }\n"
                                "  Part right { Config=Wheel Pos=0,-0.5,0 Mirror=y } }\nRobot robot0 { Config=Kit Pos=0,0,0.2 }\n"
                                "Robot robot1 { Config=Kit Pos=0,3,0.2 }\n";
        open(text);
        m_window->look({-1.6, -2.2, 1.2}, {0, -0.3, 0.2});
        take("RobotConfig.Kit.right", "tool.move");
        dragBy(kMoveZ, {0, 0, 0.1}, Qt::NoModifier, {0, -0.5, 0.2});
        QVERIFY2(m_window->text().contains("Part right { Config=Wheel Pos=0,-0.5,0.1 Mirror=y }"), m_window->text().constData());
        open(text);
        take("robot0.right.wheel", "tool.move");
        dragBy({GizmoHandle::Kind::Axis, 1}, {0, 0.1, 0}, Qt::NoModifier, {0, -0.5, 0.2});
        QVERIFY2(m_window->text().contains("Robot robot0 { Config=Kit Pos=0,0,0.2 right.wheel.Pos=0,-0.1,0 }"),
                 m_window->text().constData());
    }

    /// In the model of a robot that came with Trundle: a copy of it is changed, and what is selected is selected there.
    void partsOfShippedRobotsMove_data() {
        QTest::addColumn<std::string>("below");
        QTest::addColumn<QByteArray>("written");
        QTest::newRow("a Part") << std::string(".frontRight")
                                << QByteArray("Part frontRight { Config=CarFront Pos=$base,$(-track/2),0.1");
        QTest::newRow("in a Part") << std::string(".frontRight.knuckle") << QByteArray("body=chassis knuckle.Pos=0,0,0.05 }");
    }
    void partsOfShippedRobotsMove() {
        QFETCH(std::string, below);
        QFETCH(QByteArray, written);
        m_window->document.edits().restoreSelection(m_window->selection);
        const QByteArray text = "#import robots/car.sim\nRobot robot0 { Config=Car }\n";
        open(text);
        m_window->document.editedModel().open("RobotConfig.Car");
        m_window->look({0.9, -1.2, 0.6}, {0.2, 0, 0.1});
        take("RobotConfig.Car" + below, "tool.move");
        dragBy(kMoveZ, {0, 0, 0.05}, Qt::NoModifier, {0.3302, -0.125, 0.05});
        QVERIFY2(m_window->text().contains(written), m_window->text().constData());
        QVERIFY2(m_window->text().contains("Robot robot0 { Config=Car2 }"), m_window->text().constData());
        QCOMPARE(m_window->selection.current(), "RobotConfig.Car2" + below);
        QCOMPARE(m_window->document.edits().history().entries().size(), 1u);
        dragBy(kMoveZ, {0, 0, -0.05}, Qt::NoModifier, {0.3302, -0.125, 0.1});
        QVERIFY2(!m_window->text().contains(written) && !m_window->text().contains("Car3"), m_window->text().constData());
        m_window->document.edits().undo();
        m_window->document.edits().undo();
        QCOMPARE(m_window->text(), text);
        QCOMPARE(m_window->selection.current(), "RobotConfig.Car" + below);
    }

    /// What is in a member of a Repeat or Ring moves in the frame of the member; the Ring itself in that of its config.
    void repeatsMove() {
        const QByteArray text = "RobotConfig Kit { Body chassis { Box hull { Size=0.1,0.1,0.1 Mass=1 } }\n"
                                "  Ring arm { Count=4 Radius=0.5 Body tip { Box b { Size=0.2,0.2,0.2 Mass=1 } } }\n"
                                "  Repeat row { Count=2 Pos=$(0.3*index),0.8,0 Body c { Box b { Size=0.2,0.2,0.2 Mass=1 } } } }\n"
                                "Robot robot0 { Config=Kit Pos=0,0,0.2 }\nRobot robot1 { Config=Kit Pos=0,3,0.2 }\n";
        open(text);
        m_window->look({-1.6, -2.2, 1.2}, {0, 0, 0.2});
        take("RobotConfig.Kit.arm", "tool.move");
        dragBy(kMoveZ, {0, 0, 0.1}, Qt::NoModifier, {0, 0, 0.2});
        QVERIFY2(m_window->text().contains("Radius=0.5 Pos=0,0,0.1 Body tip {"), m_window->text().constData());
        open(text);
        take("robot0.arm_3.tip", "tool.move"); // its x points to -y
        dragBy({GizmoHandle::Kind::Axis, 1}, {0, -0.1, 0}, Qt::NoModifier, {0, -0.5, 0.2});
        QVERIFY2(m_window->text().contains("arm_3.tip.Pos=0.1,0,0 }"), m_window->text().constData());
        open(text);
        take("robot0.row_1.c", "tool.move");
        dragBy(kMoveZ, {0, 0, 0.1}, Qt::NoModifier, {0.3, 0.8, 0.2});
        QVERIFY2(m_window->text().contains("row_1.c.Pos=0,0,0.1 }"), m_window->text().constData());
        open("RobotConfig Kit { Body c { HPR=90,0,0 Ring arm { Count=4 Radius=0.5 Box b { Size=0.2,0.2,0.2 Mass=1 } } } }\n"
             "Robot robot0 { Config=Kit Pos=0,0,0.2 }\nRobot robot1 { Config=Kit Pos=0,3,0.2 }\n");
        take("robot0.c.arm_2.b", "tool.move"); // of a ring of geoms in a body
        dragBy(kMoveZ, {0, 0, 0.1}, Qt::NoModifier, {0, -0.5, 0.2});
        QVERIFY2(m_window->text().contains("arm_2.b.Pos=0,0,0.1 }"), m_window->text().constData());
    }

    /// What is in a Repeat of the world moves in the frame of its member, all members alike.
    void repeatedRobotsMove() {
        open("RobotConfig Kit { Body c { Box b { Size=0.2,0.2,0.2 Mass=1 } } }\n"
             "StaticConfig Post { Box b { Size=0.2,0.2,0.2 } }\n"
             "Ring fence { Count=4 Radius=0.5 Pos=0,0,0.2 Robot cart { Config=Kit } }\n"
             "Repeat row { Count=2 Pos=$(0.5*index),0.9,0.1 Static post { Config=Post } }\n");
        m_window->look({-1.6, -2.2, 1.2}, {0, 0, 0.2});
        take("fence_3.cart", "tool.move"); // its x points to -y
        dragBy({GizmoHandle::Kind::Axis, 1}, {0, -0.1, 0}, Qt::NoModifier, {0, -0.5, 0.2});
        QVERIFY2(m_window->text().contains("Robot cart { Config=Kit Pos=0.1,0,0 }"), m_window->text().constData());
        take("row_1.post", "tool.move");
        dragBy(kMoveZ, {0, 0, 0.1}, Qt::NoModifier, {0.5, 0.9, 0.1});
        QVERIFY2(m_window->text().contains("Static post { Config=Post Pos=0,0,0.1 }"), m_window->text().constData());
        QCOMPARE(m_window->panel->world().objectsOf("fence").size(), std::size_t(4));
        QCOMPARE(m_window->panel->world().objectsOf("fence.cart.c").size(), std::size_t(4));
        QCOMPARE(m_window->panel->world().objectsOf("row_1").size(), std::size_t(1));
        open("RobotConfig Kit { Body c { Box b { Size=0.1,0.1,0.1 Mass=1 } } }\n"
             "Ring fence { Count=4 Radius=0.5 Pos=0,0,0.2 Grid herd { Config=Kit Count=2 Spacing=0.3 } }\n");
        take("fence.herd", "tool.move"); // at the place of its first member
        dragBy(kMoveZ, {0, 0, 0.1}, Qt::NoModifier, {0.5, 0, 0.2});
        QVERIFY2(m_window->text().contains("Spacing=0.3 Pos=0,0,0.1 }"), m_window->text().constData());
    }

    /// A body moves along with the one that it is placed in, and its own numbers are in that one's frame.
    void bodiesInBodiesMove() {
        const QByteArray text = "PartConfig Wheel { Body w { Box t { Size=0.2,0.2,0.2 Mass=1 } } }\n"
                                "RobotConfig Kit { Body base { HPR=90,0,0 Box b { Size=0.2,0.2,0.2 Mass=1 } }\n"
                                "  Body arm { In=base Pos=0.5,0,0 Box b { Size=0.2,0.2,0.2 Mass=1 } }\n"
                                "  Part left { Config=Wheel In=base Pos=0,0.5,0 } }\nRobot robot0 { Config=Kit Pos=0,0,0.2 }\n";
        open(text);
        m_window->look({-1.6, -2.2, 1.2}, {0, 0, 0.2});
        const auto at = [&](const char* path) {
            const ViewportScene& world = m_window->panel->world();
            return world.poseOf(*world.find(path)).position;
        };
        QVERIFY((at("robot0.arm") - Vec3(0, 0.5, 0.2)).norm() < 1e-9);
        take("RobotConfig.Kit.arm", "tool.move"); // its x points to y
        dragBy({GizmoHandle::Kind::Axis, 1}, {0, 0.1, 0}, Qt::NoModifier, {0, 0.5, 0.2});
        QVERIFY2(m_window->text().contains("Body arm { In=base Pos=0.6,0,0 "), m_window->text().constData());
        take("RobotConfig.Kit.left", "tool.move");
        dragBy({GizmoHandle::Kind::Axis, 1}, {0, 0.1, 0}, Qt::NoModifier, {-0.5, 0, 0.2});
        QVERIFY2(m_window->text().contains("Part left { Config=Wheel In=base Pos=0.1,0.5,0 }"), m_window->text().constData());
        take("RobotConfig.Kit.base", "tool.move");
        dragBy(kMoveZ, {0, 0, 0.1}, Qt::NoModifier, {0, 0, 0.2});
        QVERIFY((at("robot0.arm") - Vec3(0, 0.6, 0.3)).norm() < 1e-9);
        QVERIFY((at("robot0.left.w") - Vec3(-0.5, 0.1, 0.3)).norm() < 1e-9);
    }

    /// A body that counts from a selected one by In, also through another or in a Part, moves along once.
    void whatCountsFromASelectedBodyMovesOnce() {
        const QByteArray text =
            "PartConfig Wheel { Body w { Box t { Size=0.2,0.2,0.2 Mass=1 } } }\n"
            "RobotConfig Kit { Body base { Box b { Size=0.2,0.2,0.2 Mass=1 } }\n"
            "  Body mast { In=base Pos=0.5,0,0 Box b { Size=0.2,0.2,0.2 Mass=1 } }\n"
            "  Body head { In=mast Pos=0,0,0.3 Box b { Size=0.1,0.1,0.1 Mass=1 } }\n"
            "  Part left { Config=Wheel In=mast Pos=0,0.5,0 } Body apart { Pos=-1,0,0 Box b { Size=0.1,0.1,0.1 Mass=1 } } }\n"
            "Robot robot0 { Config=Kit Pos=0,0,0.2 }\n";
        const auto dragged = [&](std::vector<std::string> paths, const Vec3& handle) {
            open(text);
            m_window->look({-1.6, -2.2, 1.2}, {0, 0, 0.2});
            m_window->selection.set(std::move(paths));
            m_window->trigger("tool.move");
            dragBy(kMoveZ, {0, 0, 0.1}, Qt::NoModifier, handle);
            return m_window->text();
        };
        const auto with = [&](const char* from, const char* to, QByteArray in) { return in.replace(from, to); };
        const QByteArray mast = with("mast { In=base Pos=0.5,0,0 ", "mast { In=base Pos=0.5,0,0.1 ", text);
        QCOMPARE(dragged({"robot0.head", "robot0.mast"}, {0.5, 0, 0.2}), mast);
        QCOMPARE(dragged({"RobotConfig.Kit.left", "RobotConfig.Kit.mast"}, {0.5, 0, 0.2}), mast);
        QCOMPARE(dragged({"robot0.left.w", "robot0.head", "robot0.mast"}, {0.5, 0, 0.2}), mast);
        QCOMPARE(dragged({"robot0.apart", "robot0.head"}, {0.5, 0, 0.5}),
                 with("apart { Pos=-1,0,0 ", "apart { Pos=-1,0,0.1 ", with("Pos=0,0,0.3", "Pos=0,0,0.4", text)));
    }

    /// What is placed by index moves with all members, where its text is edited; through a robot that would be one place for all.
    void placesFromIndex_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("before");
        QTest::addColumn<QString>("after"); ///< empty: it is refused
        QTest::newRow("a Repeat of the config") << "RobotConfig.Kit.row"
                                                << "row { Count=2 Pos=$(0.3*index),0.8,0 "
                                                << "row { Count=2 Pos=$(0.3*index),0.8,0.1 ";
        QTest::newRow("along index") << "RobotConfig.Kit.col"
                                     << "0.8,$(0.3*index)"
                                     << "0.8,$(0.3*index + 0.1)";
        QTest::newRow("a second time") << "RobotConfig.Kit.rim.disc"
                                       << "$(0.3*index + 0.1) Box"
                                       << "$(0.3*index + 0.2) Box";
        QTest::newRow("one member in the config") << "RobotConfig.Kit.rim_1.disc"
                                                  << "$(0.3*index + 0.1) Box"
                                                  << "$(0.3*index + 0.2) Box";
        QTest::newRow("a Param called indexer") << "RobotConfig.Kit.other"
                                                << "Pos=$indexer,0,0"
                                                << "Pos=$indexer,0,0.1";
        QTest::newRow("through a robot") << "robot0.row"
                                         << ""
                                         << "";
        QTest::newRow("in a Part") << "robot0.left.lamp"
                                   << ""
                                   << "";
        QTest::newRow("what all members have") << "robot0.rim.disc"
                                               << ""
                                               << "";
    }
    void placesFromIndex() {
        QFETCH(QString, path);
        QFETCH(QString, before);
        QFETCH(QString, after);
        const QByteArray text =
            "PartConfig Lamps { Repeat lamp { Count=2 Pos=$(0.3*index),0.8,0 Body c { Box b { Size=0.2,0.2,0.2 Mass=1 } } } }\n"
            "RobotConfig Kit { Param indexer = 0.1 Body chassis { Box hull { Size=0.1,0.1,0.1 Mass=1 } }\n"
            "  Repeat row { Count=2 Pos=$(0.3*index),0.8,0 Body c { Box b { Size=0.2,0.2,0.2 Mass=1 } } }\n"
            "  Repeat col { Count=2 Pos=0,0.8,$(0.3*index) Body c { Box b { Size=0.2,0.2,0.2 Mass=1 } } }\n"
            "  Repeat rim { Count=2 Body disc { Pos=0,-0.8,$(0.3*index + 0.1) Box b { Size=0.2,0.2,0.2 Mass=1 } } }\n"
            "  Repeat other { Count=1 Pos=$indexer,0,0 Body c { Box b { Size=0.2,0.2,0.2 Mass=1 } } }\n"
            "  Part left { Config=Lamps } }\nRobot robot0 { Config=Kit Pos=0,0,0.2 }\nRobot robot1 { Config=Kit Pos=0,3,0.2 }\n";
        open(text);
        take(path.toStdString(), "tool.move");
        auto& gizmo = m_window->view().tools().gizmo();
        QCOMPARE(!gizmo.spot(kMoveZ).has_value(), after.isEmpty());
        const auto* banner = m_window->panel->findChild<QWidget*>(QStringLiteral("viewportBanner"));
        QCOMPARE(banner->isVisible() && banner->findChild<QLabel*>()->text().contains(u"computed from index"), after.isEmpty());
        if (after.isEmpty()) return;
        TransformSelection held(m_window->view().context());
        QVERIFY(held.move({{0, 0, 0.1}, Quat::Identity()}, QStringLiteral("Move"), {}));
        QByteArray wanted = text;
        QCOMPARE(m_window->text(), wanted.replace(before.toLatin1(), after.toLatin1()));
        m_window->document.edits().undo();
        QCOMPARE(m_window->text(), text);
    }
    /// A member that has a value of its own, or gets one, is moved alone.
    void oneMemberIsMovedAlone() {
        open("RobotConfig Kit { Body chassis { Box hull { Size=0.1,0.1,0.1 Mass=1 } }\n"
             "  Repeat rim { Count=2 Body disc { Pos=$(0.3*index),-0.8,0 Box b { Size=0.2,0.2,0.2 Mass=1 } } } }\n"
             "Robot robot0 { Config=Kit Pos=0,0,0.2 }\nRobot robot1 { Config=Kit Pos=0,3,0.2 }\n");
        take("robot0.rim_1.disc", "tool.move");
        TransformSelection held(m_window->view().context());
        QVERIFY(held.move({{0.1, 0, 0}, Quat::Identity()}, QStringLiteral("Move"), {}));
        QVERIFY2(m_window->text().contains("robot0 { Config=Kit Pos=0,0,0.2 rim_1.disc.Pos=0.4,-0.8,0 }"),
                 m_window->text().constData());
    }

    void whatIsLockedIsNotMoved_data() {
        QTest::addColumn<std::string>("path");
        QTest::addColumn<std::string>("locked");
        const auto row = [](const char* path, std::string locked) { QTest::newRow(path) << std::string(path) << locked; };
        row("swarm", "swarm");
        row("fence", "fence");
        row("goal", "goal");
        row("robot0.left", "robot0.left");
        row("robot0.arm", "robot0");
        row("RobotConfig.Kit.chassis", "RobotConfig.Kit");
        row("RobotConfig.Kit.left", "RobotConfig.Kit.left");
    }
    void whatIsLockedIsNotMoved() {
        QFETCH(std::string, path);
        QFETCH(std::string, locked);
        open("PartConfig Wheel { Body wheel { Box tyre { Size=0.2,0.2,0.2 Mass=1 } } }\n"
             "RobotConfig Kit { Body chassis { Box hull { Size=0.1,0.1,0.1 Mass=1 } } Part left { Config=Wheel Pos=0,0.5,0 }\n"
             "  Ring arm { Count=4 Radius=0.5 Body tip { Box b { Size=0.2,0.2,0.2 Mass=1 } } } }\n"
             "Robot robot0 { Config=Kit Pos=0,0,0.2 }\nRobot robot1 { Config=Kit Pos=0,3,0.2 }\n"
             "Grid swarm { Config=Kit Pos=0,6,0.2 Count=2 Spacing=2 }\nRegion goal { Pos=0,-3,0.5 Size=1,1,1 }\n"
             "Ring fence { Count=4 Radius=2 Pos=0,12,0.2 Robot cart { Config=Kit } }\n");
        m_window->selection.select(path);
        QVERIFY(!TransformSelection(m_window->view().context()).empty());
        m_window->panel->world().setLocked({locked});
        const TransformSelection held(m_window->view().context());
        QVERIFY(held.empty());
        QCOMPARE(held.refusal(), QString::fromStdString(path) + QStringLiteral(" is locked."));
    }

    void lockedJointsAndDevicesHaveNoHandles() {
        open("RobotConfig Kit { Body base { Box b { Size=0.2,0.2,0.2 Mass=1 } }\n"
             "  Body arm { Pos=0,0,0.3 Box b { Size=0.2,0.2,0.2 Mass=1 } }\n"
             "  Hinge elbow { Parent=base Child=arm Axis=0,1,0 } Camera eye { Body=arm } }\nRobot robot0 { Config=Kit }\n");
        JointTool& joint = m_window->view().tools().joint();
        AimTool& aim = m_window->view().tools().aim();
        m_window->selection.select("robot0.elbow");
        QVERIFY(joint.spot(kAnchor));
        m_window->panel->world().setLocked({"robot0.elbow"});
        QVERIFY(!joint.spot(kAnchor));
        m_window->selection.select("robot0.eye");
        QVERIFY(aim.spot());
        m_window->panel->world().setLocked({"robot0"});
        QVERIFY(!aim.spot());
        m_window->panel->world().setLocked({});
        QVERIFY(aim.spot());
    }

    /// An edit of a config starts from the numbers of the config, whatever its first robot sets.
    void configsAreEditedFromTheirOwnNumbers_data() {
        QTest::addColumn<bool>("hasOther"); ///< a robot that sets nothing
        QTest::newRow("as in another robot") << true;
        QTest::newRow("as in none") << false;
    }
    void configsAreEditedFromTheirOwnNumbers() {
        QFETCH(bool, hasOther);
        const QByteArray text =
            "RobotConfig Rover { Body base { Box b { Size=0.4,0.4,0.1 Mass=1 } }\n"
            "  Body mast { Pos=0,0,0.2 Box pole { Size=0.1,0.1,0.4 Mass=1 } } Fixed f { Parent=base Child=mast } }\n"
            "Robot a { Config=Rover mast.Pos=0.5,0,0.2 mast.pole.Size=0.2,0.2,0.8 }\n" +
            QByteArray(hasOther ? "Robot b { Config=Rover Pos=0,2,0 }\n" : "");
        open(text);
        m_window->selection.select("RobotConfig.Rover.mast");
        TransformSelection held(m_window->view().context());
        QVERIFY(!held.empty() && held.pivot().position.isApprox(Vec3(0, hasOther ? 2 : 0, 0.2), 1e-9));
        QVERIFY(held.move({{0.05, 0, 0}, Quat::Identity()}, QStringLiteral("Move"), {}));
        QCOMPARE(m_window->text(), QByteArray(text).replace("Pos=0,0,0.2", "Pos=0.05,0,0.2"));
        open(text);
        m_window->selection.select("RobotConfig.Rover.mast.pole");
        TransformSelection sized(m_window->view().context(), TransformSelection::Operation::Scale);
        QVERIFY(sized.resize({0.05, 0, 0}, 0, QStringLiteral("Scale"), {}, {}));
        QCOMPARE(m_window->text(), QByteArray(text).replace("Size=0.1,0.1,0.4", "Size=0.2,0.1,0.4"));
    }

    void jointsAndDevicesOfConfigsToo_data() { configsAreEditedFromTheirOwnNumbers_data(); }
    void jointsAndDevicesOfConfigsToo() {
        QFETCH(bool, hasOther);
        const QByteArray text = "RobotConfig Kit { Body base { Box b { Size=0.2,0.2,0.2 Mass=1 } }\n"
                                "  Body arm { Pos=0,0,0.3 Box b { Size=0.2,0.2,0.2 Mass=1 } }\n"
                                "  Hinge elbow { Parent=base Child=arm Anchor=0,0,0.2 Axis=0,1,0 }\n"
                                "  Camera eye { Body=arm HPR=10,0,0 } }\n"
                                "Robot a { Config=Kit eye.HPR=90,0,0 elbow.Anchor=0.1,0,0.2 }\n" +
                                QByteArray(hasOther ? "Robot b { Config=Kit Pos=0,2,0 }\n" : "");
        open(text);
        if (hasOther) {
            m_window->selection.select("RobotConfig.Kit.elbow");
            const std::optional<EditedJoint> joint = EditedJoint::selected(m_window->view().context());
            QVERIFY(joint && joint->setAnchor(m_window->document, joint->spec().anchor + Vec3(0.05, 0, 0), 1e-4, {}));
            QCOMPARE(m_window->text(), QByteArray(text).replace("Anchor=0,0,0.2", "Anchor=0.05,0,0.2"));
            m_window->document.edits().undo();
        }
        const Vec3 eye(0, hasOther ? 2 : 0, 0.3);
        m_window->look(eye + Vec3(0, -0.01, 2), eye); // from above
        m_window->selection.select("RobotConfig.Kit.eye");
        const QPointF from = *m_window->view().tools().aim().spot(), at = m_window->at(eye);
        const QPointF way = QPointF(m_window->at(eye + Vec3(std::cos(M_PI / 6), std::sin(M_PI / 6), 0))) - at;
        m_window->drag(from, at + way * (QLineF(at, from).length() / std::hypot(way.x(), way.y())));
        QCOMPARE(m_window->text(), QByteArray(text).replace("HPR=10,0,0", "HPR=30,0,0"));
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
    void dragBy(const GizmoHandle& handle, const Vec3& by, Qt::KeyboardModifiers modifiers, Vec3 origin) {
        QVERIFY(dragHandle(*m_window, handle, by, origin, modifiers));
    }

    std::unique_ptr<RenderService> m_render;
    std::unique_ptr<ViewWindow> m_window;
};

QTEST_MAIN(MovePartsTest)
#include "move_parts_test.moc"
