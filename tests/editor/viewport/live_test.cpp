// The 3D view during a run: pinned values, moving and pushing robots, contacts.
#include <QtTest>

#include "editor/document/structure_edits.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/gizmo/gizmo_tool.h"
#include "editor/viewport/overlays/contact_arrows.h"
#include "editor/viewport/overlays/pinned_values.h"
#include "editor/viewport/view_window.h"
#include "eventually.h"
#include "project/edits/plans.h"

using namespace trundle;

class LiveTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_render = RenderService::startInBackground(); }
    void init() {
        m_window = std::make_unique<ViewWindow>(m_render.get());
        QVERIFY(m_window->open(kRoom));
        m_window->look({-0.2, -2.6, 2.2}, {-0.2, 0, 0});
    }
    void cleanup() { m_window.reset(); }

    void aRunIsShownWhereItIs() {
        step();
        QVERIFY(m_window->panel->world().isRunning());
        m_window->session.reset();
        EVENTUALLY(!m_window->panel->world().isRunning());
        QVERIFY(((*m_window->panel->world().poses())[0].position - Vec3(-0.5, 0, 0)).norm() < 1e-12);
    }

    void valuesArePinnedOverTheView() {
        QAction& pin = m_window->actions.at("view.pinValues");
        const auto shown = [this] { return m_window->view().grab().toImage().copy(8, 44, 180, 80); };
        EVENTUALLY(m_window->panel->views().isUpToDate());
        const QImage plain = shown();
        m_window->selection.select("robot0.leftMotor");
        QVERIFY(!pin.isChecked());
        m_window->trigger("view.pinValues");
        QCOMPARE(m_window->panel->pinned().paths(), std::vector<std::string>{"robot0.leftMotor"});
        QVERIFY(pin.isChecked());
        const QImage atStart = shown();
        const int floor = qGray(plain.pixel(4, 12)), label = qGray(atStart.pixel(4, 12));
        QVERIFY2(label < floor - 40, qPrintable(QStringLiteral("%1 %2").arg(floor).arg(label))); // dark text on a lighter floor
        step();
        EVENTUALLY(shown() != atStart);
        m_window->selection.select("robot1");
        QVERIFY(!pin.isChecked());
        m_window->trigger("view.pinValues");
        QCOMPARE(m_window->panel->pinned().paths().size(), 2u);
        // Pins of missing objects are removed; the same action unpins.
        m_window->selection.clear();
        QVERIFY(m_window->document.edits()
                    .apply(QStringLiteral("Delete"), planRemove(*m_window->document.loaded(), {"robot1"}))
                    .ok());
        QCOMPARE(m_window->panel->pinned().paths(), std::vector<std::string>{"robot0.leftMotor"});
        m_window->selection.select("robot0.leftMotor");
        QVERIFY(pin.isChecked());
        m_window->trigger("view.pinValues");
        QVERIFY(m_window->panel->pinned().paths().empty() && !pin.isChecked());
    }

    /// In a view narrower than its columns a label shows the numbers below each other instead of beyond the edge.
    void pinnedLabelsFitIntoNarrowViews() {
        PinnedValues& pinned = m_window->panel->pinned();
        pinned.set({"robot0", "robot0.leftMotor"}, true);
        step(); // before the run there are no values
        View& view = m_window->view();
        const QSize before = view.size();
        QSizeF least(1e9, 1e9), most;
        for (const int width : {420, 300, 240, 180, 160}) {
            view.resize(width, before.height());
            const std::vector<PinnedLabel> labels = pinnedLabels(view);
            QVERIFY(!labels.empty());
            for (const PinnedLabel& label : labels) {
                QVERIFY2(label.rect.left() >= 0 && label.rect.right() <= view.width(), qPrintable(QString::number(width)));
                QVERIFY(label.rect.contains(label.close.center()));
            }
            least = least.boundedTo(labels.front().rect.size());
            most = most.expandedTo(labels.front().rect.size());
        }
        QVERIFY(most.width() > least.width() && most.height() > least.height());
        view.resize(before);
        pinned.setPins({});
    }

    /// However it is renamed: in the tree, by typing, or by undo. A text with errors keeps the pins.
    void pinsFollowRenames() {
        PinnedValues& pinned = m_window->panel->pinned();
        pinned.set({"robot0", "robot0.leftMotor", "robot1", ""}, true);
        pinned.move("robot0", QPointF(0.5, 0.5));
        using Paths = std::vector<std::string>;
        QVERIFY(m_window->document.structure().rename(QStringLiteral("Rename"), "robot0", "rover").ok());
        QCOMPARE(pinned.paths(), (Paths{"rover", "rover.leftMotor", "robot1", ""}));
        QCOMPARE(*pinned.pins().front().position, QPointF(0.5, 0.5));
        m_window->document.edits().undo();
        QCOMPARE(pinned.paths(), (Paths{"robot0", "robot0.leftMotor", "robot1", ""}));
        const auto put = [this](const QByteArray& text) {
            return m_window->document.edits()
                .replaceText(QStringLiteral("Type"), m_window->document.texts().files().front(), text.toStdString())
                .ok();
        };
        QVERIFY(put(QByteArray(kRoom).replace("Robot robot0 {", "Robot  {")) &&
                put(QByteArray(kRoom).replace("Robot robot0 {", "Robot ro {")));
        QCOMPARE(pinned.paths(), (Paths{"ro", "ro.leftMotor", "robot1", ""}));
        QVERIFY(put(QByteArray(kRoom).replace("robot1", "robot2").replace("robot0", "robot3"))); // two at once
        QCOMPARE(pinned.paths(), (Paths{"robot3", "robot3.leftMotor", "robot2", ""}));
    }

    /// A View changed during a run is shown at once and does not wait for a reset, unless the run takes pictures from it.
    void viewsAreEditedDuringARun() {
        const QByteArray view = "View overview { Eye=3,-4,3 Target=0,0,0 }\n",
                         log = "FrameLog frames { View=overview Interval=1 }\n";
        for (const bool logged : {false, true}) {
            QVERIFY(m_window->open(kRoom + view + (logged ? log : QByteArray())));
            QVERIFY(m_window->panel->views().showView(QStringLiteral("overview")));
            step();
            QVERIFY(!m_window->session.edits().needsReset());
            QVERIFY(m_window->document.structure().setValues(QStringLiteral("Set"), {{"overview.Eye", "1,2,3"}}).ok());
            EVENTUALLY((m_window->view().camera().free().view().eye - Vec3(1, 2, 3)).norm() < 1e-9);
            QCOMPARE(m_window->session.edits().needsReset(), logged);
            if (logged) continue;
            m_window->document.edits().undo();
            QVERIFY(m_window->document.edits()
                        .apply(QStringLiteral("Delete"), planRemove(*m_window->document.loaded(), {"overview"}))
                        .ok());
            QVERIFY(!m_window->session.edits().needsReset());
        }
    }

    /// What no image shows keeps the scene; anything else needs a new one.
    void frictionNeedsNoNewScene() {
        QVERIFY(m_window->open(kRoom + "Surface ice { Friction=0.5 }\n"));
        const ViewportScene& world = m_window->panel->world();
        const SceneId scene = world.scene();
        QVERIFY(m_window->document.structure().setValues(QStringLiteral("Set"), {{"Surface.ice.Friction", "0.25"}}).ok());
        QVERIFY(world.scene() == scene);
        QVERIFY(std::ranges::any_of(world.objects()->experiment().surfaces, [](const auto& s) { return s.friction == 0.25; }));
        QVERIFY(m_window->document.structure().setValues(QStringLiteral("Set"), {{"robot1.Pos", "0,1,0"}}).ok());
        QVERIFY(world.scene() != scene);
    }

    void pinnedLabelsAreDraggedAndClosed() {
        PinnedValues& pinned = m_window->panel->pinned();
        pinned.set({"robot0", "robot0.leftMotor"}, true);
        EVENTUALLY(m_window->panel->views().isUpToDate());
        const auto label = [this](const char* path) {
            for (const PinnedLabel& each : pinnedLabels(m_window->view()))
                if (each.path == path) return each;
            return PinnedLabel();
        };
        const QRectF robot = label("robot0").rect, motor = label("robot0.leftMotor").rect;
        QVERIFY(motor.top() > robot.bottom()); // one below the other
        const QPointF from = motor.center(), to = from + QPointF(400, 150);
        m_window->drag(from, to);
        QVERIFY2((label("robot0.leftMotor").rect.center() - to).manhattanLength() < 2, "it goes with the mouse");
        QVERIFY(m_window->selection.empty()); // the click did not select the object behind it
        QCOMPARE(label("robot0").rect, robot);
        m_window->panel->resize(700, 600); // the relative position is kept
        const QRectF moved = label("robot0.leftMotor").rect;
        QVERIFY(QRectF(m_window->view().rect()).contains(moved));
        m_window->click(moved.center());
        QCOMPARE(m_window->selection.current(), std::string("robot0.leftMotor"));
        m_window->drag(moved.center(), QPointF(-500, -500)); // it stays inside the view
        QVERIFY(QRectF(m_window->view().rect()).contains(label("robot0.leftMotor").rect));
        const QPointF back = label("robot0.leftMotor").rect.center();
        m_window->press(back);
        m_window->move(back + QPointF(200, 200), {}, Qt::LeftButton);
        m_window->key(Qt::Key_Escape);
        QVERIFY((label("robot0.leftMotor").rect.center() - back).manhattanLength() < 2);
        m_window->release(back);
        m_window->click(label("robot0.leftMotor").close.center());
        QCOMPARE(pinned.paths(), std::vector<std::string>{"robot0"});
        QVERIFY(m_window->open(kRoom)); // another experiment has no pins
        QVERIFY(pinned.paths().empty());
    }

    void aDragInAPausedRunMovesTheWorldOnly() {
        step();
        m_window->selection.select("robot0");
        m_window->trigger("tool.move");
        const GizmoHandle x{GizmoHandle::Kind::Axis, 0};
        QVERIFY(m_window->view().tools().gizmo().spot(x));
        const QPointF from = *m_window->view().tools().gizmo().spot(x);
        m_window->drag(from, from + QPointF(120, 0));
        QCOMPARE(m_window->text(), kRoom);
        QVERIFY(m_window->session.robots().pose("robot0")->position.x() > -0.4);
        // Changed poses can be kept.
        auto* keep = m_window->panel->findChild<QWidget*>(QStringLiteral("bannerButton"));
        EVENTUALLY(keep->isVisible());
        QTest::mouseClick(keep, Qt::LeftButton);
        QVERIFY(m_window->text() != kRoom);
        m_window->document.edits().undo();
        QCOMPARE(m_window->text(), kRoom);
    }

    void escapePutsTheWorldBack() {
        step();
        m_window->selection.select("robot0");
        m_window->trigger("tool.move");
        const Vec3 before = m_window->session.robots().pose("robot0")->position;
        const QPointF from = *m_window->view().tools().gizmo().spot({GizmoHandle::Kind::Axis, 0});
        m_window->press(from);
        m_window->move(from + QPointF(120, 0), {}, Qt::LeftButton);
        QVERIFY((m_window->session.robots().pose("robot0")->position - before).norm() > 0.05);
        m_window->key(Qt::Key_Escape);
        QVERIFY((m_window->session.robots().pose("robot0")->position - before).norm() < 1e-6);
        QVERIFY(!m_window->document.edits().history().canUndo());
    }

    void partsAreNotMovedInARun() {
        step();
        m_window->selection.select("robot0.chassis.hull");
        m_window->trigger("tool.move");
        QVERIFY(!m_window->view().tools().gizmo().spot({GizmoHandle::Kind::Axis, 0}));
    }

    void lockedRobotsAreNotMovedInARun() {
        step();
        m_window->selection.select("robot0");
        m_window->trigger("tool.move");
        const GizmoHandle x{GizmoHandle::Kind::Axis, 0};
        QVERIFY(m_window->view().tools().gizmo().spot(x));
        m_window->panel->world().setLocked({"robot0"});
        QVERIFY(!m_window->view().tools().gizmo().spot(x));
    }

    void ctrlAndADragPushesABody() {
        m_window->session.run();
        EVENTUALLY(m_window->panel->world().isRunning());
        const QPointF hull = m_window->at({-0.5, 0, 0.13});
        m_window->press(hull, Qt::LeftButton, Qt::ControlModifier);
        m_window->move(hull + QPointF(150, 0), Qt::ControlModifier, Qt::LeftButton);
        EVENTUALLY(m_window->session.robots().pose("robot0")->position.x() > -0.45);
        m_window->release(hull + QPointF(150, 0), Qt::LeftButton, Qt::ControlModifier);
        QVERIFY(m_window->selection.empty());
        // A press without a drag is a click.
        m_window->click(m_window->at(m_window->session.robots().pose("robot0")->position + Vec3(0, 0, 0.13)),
                        Qt::ControlModifier);
        QCOMPARE(m_window->selection.paths(), std::vector<std::string>{"robot0"});
        QCOMPARE(m_window->text(), kRoom);
    }

    void followKeepsRobotInImage() {
        step();
        m_window->selection.select("robot1");
        m_window->trigger("view.follow");
        const QPointF before = *m_window->view().camera().pixelOf(m_window->session.robots().pose("robot1")->position);
        QVERIFY(m_window->session.robots().place("robot1", {Vec3(-1, -1, 0), Quat::Identity()}));
        EVENTUALLY((m_window->session.robots().pose("robot1")->position - Vec3(-1, -1, 0)).norm() < 1e-3);
        QVERIFY(QLineF(*m_window->view().camera().pixelOf(m_window->session.robots().pose("robot1")->position), before).length() <
                1);
    }

    void aDrivenRobotStaysInThePicture() {
        m_window->session.run();
        EVENTUALLY(m_window->panel->world().isRunning());
        QVERIFY(m_window->session.robots().drive("robot1", 0.3, 0));
        EVENTUALLY(m_window->session.robots().pose("robot1")->position.x() > 0.6);
        QCOMPARE(m_window->view().camera().free().kind(), ViewKind::Perspective); // it is visible, so the view does not move
        m_window->session.robots().stopDriving();
        m_window->look({-0.5, -0.6, 0.4}, {-0.5, 0, 0});
        m_window->selection.select("robot0");
        QVERIFY(m_window->session.robots().drive("robot0", 0.6, 0));
        EVENTUALLY_EQUAL(m_window->view().camera().free().kind(), ViewKind::Follow);
        QVERIFY(m_window->view().rect().contains(m_window->at(m_window->session.robots().pose("robot0")->position)));
        QVERIFY(m_window->open(kRoom)); // the followed robot is missing
        QCOMPARE(m_window->view().camera().free().kind(), ViewKind::Perspective);
    }

    void framesExperimentOpenedDuringRun() {
        step();
        m_window->look({50, 50, 50}, {60, 60, 60});
        QVERIFY(m_window->open(kRoom));
        EVENTUALLY(m_window->view().camera().pixelOf({-0.5, 0, 0}));
        EVENTUALLY(m_window->view().rect().contains(m_window->view().camera().pixelOf({-0.5, 0, 0})->toPoint()));
    }

    void arrowsAreAsLongAsTheForceUpToALimit() {
        const double unit = forceUnit(m_window->panel->world().objects()->experiment());
        QCOMPARE(unit, 20.0); // SimpleRobot weighs 24 N
        std::vector<LiveContact> contacts(2000);
        for (std::size_t i = 0; i < contacts.size(); ++i) contacts[i].force = 0.1 * double(i % 7);
        contacts[1500].force = 20;
        contacts[1600].force = 5;
        contacts[1700].force = 1e6;
        const auto arrows = contactArrows(contacts, unit);
        QCOMPARE(arrows.size(), kMaxContacts);
        const auto of = [&](double force) {
            return *std::ranges::find_if(arrows, [&](const ContactArrow& a) { return a.contact->force == force; });
        };
        QCOMPARE(of(20).pixels, kForcePixels);
        QCOMPARE(of(5).pixels, kForcePixels / 4);
        QVERIFY(!of(20).isCut && of(1e6).isCut);
        QCOMPARE(of(1e6).pixels, kMaxForcePixels);
        QVERIFY(std::ranges::all_of(arrows, [](const ContactArrow& a) { return a.contact->force > 0.3; })); // the strongest
    }

    void contactsAndTrailsAreDrawn() {
        m_window->trigger("view.overlayContacts");
        m_window->trigger("view.overlayTrails");
        step();
        EVENTUALLY(m_window->session.results().snapshot && m_window->session.results().snapshot->contacts);
        QVERIFY(!m_window->session.results().snapshot->contacts->empty());
        EVENTUALLY(m_window->panel->views().isUpToDate());
        QVERIFY(!m_window->view().grab().isNull());
    }

private:
    void step() {
        m_window->session.step();
        EVENTUALLY_EQUAL(m_window->session.state(), RunState::Paused);
        EVENTUALLY(m_window->session.results().poses != nullptr);
    }
    std::unique_ptr<RenderService> m_render;
    std::unique_ptr<ViewWindow> m_window;
};

QTEST_MAIN(LiveTest)
#include "live_test.moc"
