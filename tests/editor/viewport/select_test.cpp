// Selecting objects in a 3D view by clicks and rectangles.
#include <QtTest>

#include <QImage>
#include <QLabel>
#include <QPainter>

#include "editor/viewport/context/view_hints.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/gizmo/gizmo_tool.h"
#include "editor/viewport/overlays/regions.h"
#include "editor/viewport/overlays/selected_names.h"
#include "editor/viewport/view/view.h"
#include "editor/viewport/view_window.h"
#include "eventually.h"

using namespace trundle;

namespace {

using Paths = std::vector<std::string>;

} // namespace

class SelectTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_render = RenderService::startInBackground(); }

    void init() {
        m_window = std::make_unique<ViewWindow>(m_render.get());
        QVERIFY(m_window->open(kRoom));
        m_window->look({0, -2.5, 2.5}, {0, 0, 0});
    }
    void cleanup() { m_window.reset(); }

    void aClickSelectsTheRobot() {
        m_window->click(m_window->at({-0.5, 0, 0.14}));
        QCOMPARE(m_window->selection.paths(), Paths{"robot0"});
        m_window->click(m_window->at({0.5, 0.3, 0.14}));
        QCOMPARE(m_window->selection.paths(), Paths{"robot1"});
        m_window->click(m_window->at({0, -1, 0})); // empty floor
        QVERIFY(m_window->selection.empty());
    }

    void clicksAtOnePlaceGoDeeperAndThenBehind() {
        const QPoint hull = m_window->at({-0.5, 0, 0.14});
        Paths seen;
        for (int i = 0; i < 7; ++i) {
            m_window->click(hull);
            seen.push_back(m_window->selection.current());
        }
        QCOMPARE(seen,
                 (Paths{"robot0", "robot0.chassis", "robot0.chassis.hull", "arena", "arena.floor", "robot0", "robot0.chassis"}));
        // A click elsewhere starts again with the front object.
        m_window->click(m_window->at({-0.44, -0.13, 0.06}));
        QCOMPARE(m_window->selection.current(), std::string("robot0"));
    }

    void bareFloorIsNothingFirstAndTheArenaThen() {
        const QPoint floor = m_window->at({0, -1, 0});
        Paths seen;
        for (int i = 0; i < 4; ++i) {
            m_window->click(floor);
            seen.push_back(m_window->selection.current());
        }
        QCOMPARE(seen, (Paths{"", "arena", "arena.floor", ""}));
    }

    void ctrlTogglesSelection() {
        m_window->click(m_window->at({-0.5, 0, 0.14}));
        m_window->click(m_window->at({0.5, 0.3, 0.14}), Qt::ControlModifier);
        QCOMPARE(m_window->selection.paths(), (Paths{"robot0", "robot1"}));
        m_window->click(m_window->at({-0.5, 0, 0.14}), Qt::ControlModifier);
        QCOMPARE(m_window->selection.paths(), Paths{"robot1"});
    }

    void boxSelectsRobotsInside() {
        m_window->drag({5, 100}, {890, 690});
        QCOMPARE(m_window->selection.paths(), (Paths{"robot0", "robot1"}));
        const QPointF left = m_window->at({-0.5, 0, 0.07});
        m_window->drag(left - QPointF(80, 80), left + QPointF(80, 80));
        QCOMPARE(m_window->selection.paths(), Paths{"robot0"});
        const QPointF right = m_window->at({0.5, 0.3, 0.07});
        m_window->drag(right - QPointF(80, 80), right + QPointF(80, 80), Qt::LeftButton, Qt::ShiftModifier);
        QCOMPARE(m_window->selection.paths(), (Paths{"robot0", "robot1"}));
        m_window->drag({5, 60}, {30, 80});
        QVERIFY(m_window->selection.empty());
    }

    void escapeLeavesABoxAndThenClears() {
        m_window->selection.select("robot1");
        m_window->press({10, 100});
        m_window->move({600, 600}, {}, Qt::LeftButton);
        m_window->key(Qt::Key_Escape);
        m_window->release({600, 600});
        QCOMPARE(m_window->selection.paths(), Paths{"robot1"});
        m_window->key(Qt::Key_Escape);
        QVERIFY(m_window->selection.empty());
    }

    void releaseElsewhereEndsBoxSelection() {
        m_window->press({5, 60});
        m_window->move({30, 80}, {}, Qt::LeftButton);
        QVERIFY(m_window->view().isMouseBusy());
        m_window->move({890, 690}); // no button is pressed any more
        QVERIFY(!m_window->view().isMouseBusy());
        QCOMPARE(m_window->selection.paths(), (Paths{"robot0", "robot1"}));
    }

    void ignoresHiddenAndLockedObjects() {
        m_window->panel->world().setHidden({"robot0"});
        m_window->click(m_window->at({-0.5, 0, 0.14}));
        QVERIFY(m_window->selection.empty());
        m_window->panel->world().setHidden({});
        m_window->panel->world().setLocked({"robot0"});
        m_window->click(m_window->at({-0.44, 0.05, 0.14}));
        QVERIFY(m_window->selection.empty());
        m_window->drag({5, 100}, {890, 690});
        QCOMPARE(m_window->selection.paths(), Paths{"robot1"});
        m_window->panel->world().setLocked({"robot0.chassis"}); // its body is locked, the robot is not
        m_window->drag({5, 100}, {890, 690});
        QCOMPARE(m_window->selection.paths(), (Paths{"robot0", "robot1"}));
    }

    void theCursorNamesWhatItWouldSelect() {
        m_window->move(m_window->at({-0.5, 0, 0.14}));
        EVENTUALLY(m_window->panel->views().isUpToDate());
        const int before = m_window->view().image().redraws();
        m_window->move(m_window->at({-0.49, 0, 0.14})); // the same robot
        m_window->move(m_window->at({-0.48, 0, 0.14}));
        EVENTUALLY(m_window->panel->views().isUpToDate());
        QCOMPARE(m_window->view().image().redraws(), before);
        m_window->move(m_window->at({0.5, 0.3, 0.14}));
        EVENTUALLY_EQUAL(m_window->view().image().redraws(), before + 1);
    }

    /// The hint beside a resting mouse names what is below it after the camera has moved.
    void theHintFollowsTheCamera() {
        const ViewHints& hints = m_window->view().hints();
        m_window->move(m_window->at({-0.5, 0, 0.14}));
        QCOMPARE(hints.hovered(), std::string("robot0"));
        m_window->selection.select("robot1");
        m_window->trigger("view.frame"); // glides, or jumps if there is no image yet
        EVENTUALLY(!m_window->view().camera().isMoving() && hints.hovered() != "robot0");
        m_window->look({0.5, -1, 1}, {0.5, 0.3, 0.1});
        m_window->move(m_window->at({0.5, 0.3, 0.14}));
        QCOMPARE(hints.hovered(), std::string("robot1"));
        m_window->look({0.5, -1, 1}, {5, 5, 5});
        QVERIFY(hints.hovered() != "robot1");
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(&m_window->view(), &leave);
        m_window->look({0.5, -1, 1}, {0.5, 0.3, 0.1});
        QCOMPARE(hints.hovered(), std::string());
    }

    void membersOfAGridAreSelectedByTheirName() {
        QVERIFY(m_window->open(
            "#import robots/simple_robot.sim\nGrid swarm { Config=SimpleRobot Pos=0,0,0 Count=3,2 Spacing=0.8,0.8 }\n"));
        m_window->look({0, -2.5, 2.5}, {0, 0, 0});
        m_window->click(m_window->at({0.8, 0.4, 0.14}));
        QCOMPARE(m_window->selection.paths(), Paths{"swarm_5"});
        // A selected Grid includes all its members.
        QCOMPARE(m_window->panel->world().objectsOf("swarm").size(), std::size_t(6));
        QCOMPARE(m_window->panel->world().objectsOf("RobotConfig.SimpleRobot.leftWheel").size(), std::size_t(6));
    }

    /// It is selected where the caret is in the text outside of all blocks: nothing is highlighted then.
    void theExperimentIsNoObject() {
        m_window->selection.select("");
        QVERIFY(m_window->panel->world().objectsOf("").empty());
        QVERIFY(!m_window->panel->world().objectsOf("robot0").empty());
    }

    /// Also of the geoms of a body: all members are highlighted, and there are handles.
    void aRepeatIsAllItsMembers() {
        QVERIFY(m_window->open("RobotConfig Kit { Body frame { Box bed { Size=0.2,0.2,0.2 Mass=1 }\n"
                               "    Ring bolt { Count=6 Radius=0.2 Box head { Size=0.05,0.05,0.05 Mass=0.1 } } }\n"
                               "  Repeat roller { Count=3 Pos=0,0.5,0\n"
                               "    Body drum { Pos=$(0.3*index),0,0 Box tube { Size=0.1,0.1,0.1 Mass=1 } } } }\n"
                               "Robot one { Config=Kit Pos=0,0,0.2 }\nRobot two { Config=Kit Pos=0,2,0.2 }\n"));
        const auto count = [&](const char* path) { return m_window->panel->world().objectsOf(path).size(); };
        QCOMPARE(count("one.frame.bolt"), std::size_t(6));
        QCOMPARE(count("one.frame.bolt.head"), std::size_t(6));
        QCOMPARE(count("one.frame.bolt_2"), std::size_t(1));
        QCOMPARE(count("RobotConfig.Kit.frame.bolt"), std::size_t(12));
        QCOMPARE(count("one.roller"), std::size_t(3));
        QCOMPARE(count("one.roller.drum.tube"), std::size_t(3));
        QCOMPARE(count("one.frame.nothing"), std::size_t(0));
        m_window->trigger("tool.move");
        m_window->selection.select("one.frame.bolt");
        QVERIFY(m_window->view().tools().gizmo().spot({GizmoHandle::Kind::Axis, 0}));
    }

    /// Inside of its edges the floor is selected, and what stands on it.
    void aRegionIsSelectedAtItsEdges() {
        QVERIFY(m_window->open(kRoom + "Region goal { Pos=0,-0.6,0.1 Size=0.4,0.4,0.2 Robots=robot0 }\n"));
        m_window->look({0, -2.5, 2.5}, {0, 0, 0});
        m_window->click(m_window->at({0.1, -0.8, 0.2})); // of its upper front edge
        QCOMPARE(m_window->selection.paths(), Paths{"goal"});
        m_window->click(m_window->at({0, -0.6, 0}));
        QVERIFY(m_window->selection.empty());
        m_window->click(m_window->at({0.2, -0.4, 0.05})); // of an upright edge, on the floor
        QCOMPARE(m_window->selection.paths(), Paths{"goal"});
        m_window->trigger("view.frame");
        EVENTUALLY(!m_window->view().camera().isMoving());
        const QPointF off = m_window->at({0, -0.6, 0.1}) - m_window->view().rect().center();
        QVERIFY2(off.manhattanLength() < 30 && m_window->view().camera().free().distance() < 2,
                 qPrintable(QStringLiteral("%1 %2").arg(off.x()).arg(off.y())));
    }

    /// What is beside the cursor gives way to the hint at the lower edge.
    void textsOfAViewDoNotOverlap() {
        ViewHints hints;
        const QSize size(600, 300);
        const auto painted = [&](const QPoint& cursor) {
            QImage image(size, QImage::Format_ARGB32_Premultiplied);
            image.fill(Qt::transparent);
            QPainter painter(&image);
            hints.paint(painter, size, cursor);
            return image;
        };
        hints.setHint(QStringLiteral("Type an exact value"));
        const QImage hint = painted({});
        hints.setHovered({}, QStringLiteral("x 0.125 m"));
        for (int y = 0; y < size.height(); y += 5) {
            const QImage both = painted({size.width() / 2, y});
            for (int row = 0; row < size.height(); ++row)
                for (int x = 0; x < size.width(); ++x)
                    if (qAlpha(hint.pixel(x, row)) > 0) QCOMPARE(both.pixel(x, row), hint.pixel(x, row));
            QVERIFY(both != hint);
        }
    }

    /// cart_2, hull_1 and goal_1 are things of their own, and no members of cart, hull and goal.
    void aNameThatIsAlikeIsNotMeant() {
        QVERIFY(m_window->open("RobotConfig Cart { Body b { Box hull { Size=0.2,0.2,0.1 Mass=1 }\n"
                               "  Box hull_1 { Size=0.1,0.1,0.3 Mass=1 } }\n"
                               "  Camera eye { Body=b Resolution=32,24 } }\n"
                               "Robot cart { Config=Cart } Robot cart_2 { Config=Cart Pos=1,0,0 }\n"
                               "Region goal { Size=1,1,1 } Region goal_1 { Size=1,1,1 Pos=5,0,0 }\n"));
        const ViewContext& context = m_window->view().context();
        QCOMPARE(context.world.camerasOf("cart").size(), std::size_t(1));
        QCOMPARE(context.world.camerasOf("cart_2").size(), std::size_t(1));
        context.world.setHidden({"cart", "cart_2.b.hull"});
        const auto isHidden = [&](const char* path) { return context.world.isHidden(*context.world.find(path)); };
        QVERIFY(isHidden("cart") && isHidden("cart.b.hull_1") && !isHidden("cart_2"));
        QVERIFY(isHidden("cart_2.b.hull") && !isHidden("cart_2.b.hull_1"));
        m_window->selection.select("goal");
        QVERIFY(isSelected(context, "goal") && !isSelected(context, "goal_1"));
        const ExperimentSpec& experiment = context.world.objects()->experiment();
        QVERIFY(boundsOfRegions(experiment, "goal").high.x() < 1 && boundsOfRegions(experiment, "goal_1").high.x() > 5);
    }

    void nothingToPickInAnEmptyText() {
        QVERIFY(m_window->open("Tick = 0.01\n"));
        m_window->click({300, 300});
        m_window->drag({10, 10}, {800, 600});
        m_window->key(Qt::Key_Escape);
        QVERIFY(m_window->selection.empty());
    }

private:
    std::unique_ptr<RenderService> m_render;
    std::unique_ptr<ViewWindow> m_window;
};

QTEST_MAIN(SelectTest)
#include "select_test.moc"
