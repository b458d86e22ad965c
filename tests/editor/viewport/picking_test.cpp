// What clicks and boxes select, what the mouse says about it, the panel of joint positions, and what a picture of a view shows.
#include <numbers>

#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QtTest>

#include "editor/viewport/context/joint_positions.h"
#include "editor/viewport/context/view_settings.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/overlays/pinned_values.h"
#include "editor/viewport/tools/picking.h"
#include "editor/viewport/view/picture_request.h"
#include "editor/viewport/view_window.h"

using namespace trundle;

namespace {

const QByteArray kYard = R"(RobotConfig Cart {
  Body base { Box hull { Size=0.4,0.4,0.2 Pos=0,0,0.1 Mass=2 } }
  Body lift { Pos=0,0,0.3 Box fork { Size=0.2,0.2,0.1 Mass=1 } }
  Body wheel { Pos=0,0.3,0.1 Sphere s { Radius=0.05 Mass=0.1 } }
  Slider mast { Parent=base Child=lift Axis=0,0,1 LowStop=-0.05 HighStop=0.2 }
  Hinge arm { Parent=base Child=wheel Axis=0,1,0 LowStop=-30 HighStop=60 }
  Camera eye { Body=base Pos=0.2,0,0.3 SeesSelf=false }
}
StaticConfig Wall { Box wall { Size=2,0.2,1 Pos=0,0,0.5 } }
StaticConfig Ground { Plane floor { } }
Static ground { Config=Ground }
Static wall { Config=Wall Pos=0,2,0 }
Robot cart { Config=Cart }
Robot cart_2 { Config=Cart Pos=1.5,0,0 }
Region zone { Pos=0,-1.2,0.2 Size=1,0.5,0.4 }
)";

} // namespace

class PickingTest : public QObject {
    Q_OBJECT

    std::unique_ptr<ViewWindow> m_window;

    ViewportScene& world() { return m_window->panel->world(); }
    QPointF pixel(const Vec3& point) { return *m_window->view().camera().pixelOf(point); }
    std::string selectedAt(const Vec3& point, Qt::KeyboardModifiers held = {}) {
        m_window->click(pixel(point), held);
        return m_window->selection.current();
    }

private Q_SLOTS:
    void init() {
        m_window = std::make_unique<ViewWindow>(nullptr);
        QVERIFY(m_window->open(kYard));
        QVERIFY(!m_window->document.loaded()->diagnostics.hasErrors());
        m_window->look({0.7, -4.5, 3.5}, {0.7, 0, 0});
    }
    void cleanup() { m_window.reset(); }

    /// Robots by their centres, scenery as a whole; nothing that is hidden or locked.
    void whatABoxSelects() {
        const auto picked = [&](const QRectF& box) {
            QByteArrayList all;
            for (const std::string& path : boxPick(m_window->view(), box)) all << QByteArray::fromStdString(path);
            return all.join(' ');
        };
        const QRectF all(QPointF(0, 0), QSizeF(m_window->view().size()));
        QCOMPARE(picked(all), QByteArray("cart cart_2 wall"));
        const QRectF around(pixel({-0.15, 0, 0.15}), pixel({0.15, 0, 0.15}) + QPointF(0, 30));
        QCOMPARE(picked(around.adjusted(0, -30, 0, 0)), QByteArray("cart"));
        for (int corner = 0; corner < 8; ++corner) { // without one corner of the wall
            const QPointF out = pixel({corner & 1 ? 1 : -1, corner & 2 ? 2.1 : 1.9, corner & 4 ? 1 : 0});
            QRectF box = all;
            if (corner & 1) box.setRight(out.x() - 1);
            else box.setLeft(out.x() + 1);
            if (corner & 4) box.setTop(0);
            QVERIFY(!picked(box).contains("wall"));
        }
        world().setHidden({"cart"});
        QCOMPARE(picked(all), QByteArray("cart_2 wall"));
        world().setHidden({});
        world().setLocked({"cart_2", "wall"});
        QCOMPARE(picked(all), QByteArray("cart"));
    }

    /// The robot, its body, its geom, then what is behind; a region's edge goes before the floor and after everything else.
    void whatClicksSelect() {
        const Vec3 top(0.05, -0.05, 0.35);
        const char* chain[] = {"cart", "cart.lift", "cart.lift.fork", "cart.base"};
        for (const char* path : chain) QCOMPARE(selectedAt(top), std::string(path));
        QCOMPARE(selectedAt({-1.2, -1, 0}), std::string()); // the floor
        QCOMPARE(selectedAt({0, -1.45, 0}), std::string("zone"));
        m_window->selection.select("wall");
        (void)selectedAt({-1.2, -1, 0}, Qt::ControlModifier); // the floor takes nothing away
        QCOMPARE(m_window->selection.paths(), std::vector<std::string>{"wall"});
        (void)selectedAt(top, Qt::ShiftModifier);
        QCOMPARE(m_window->selection.paths(), (std::vector<std::string>{"wall", "cart"}));
        (void)selectedAt({0, 2, 1}, Qt::ControlModifier);
        QCOMPARE(m_window->selection.paths(), std::vector<std::string>{"cart"});
        const QPointF wall = pixel({0.2, 1.9, 0.5}); // a tremble is a click, not a box
        m_window->drag(wall, wall + QPointF(2, 2));
        QCOMPARE(m_window->selection.paths(), std::vector<std::string>{"wall"});
        m_window->document.editedModel().open("RobotConfig.Cart");
        m_window->view().setFocus();
        m_window->look({0.7, -4.5, 3.5}, {0.7, 0, 0});
        QCOMPARE(selectedAt(top), std::string("RobotConfig.Cart.lift"));
        QCOMPARE(selectedAt(top), std::string("RobotConfig.Cart.lift.fork"));
    }

    void whatTheMouseSays_data() {
        QTest::addColumn<QList<double>>("point");
        QTest::addColumn<QByteArray>("path");
        QTest::newRow("robot") << QList<double>{1.55, -0.05, 0.35} << QByteArray("cart_2");
        QTest::newRow("scenery") << QList<double>{0.2, 1.9, 0.5} << QByteArray("wall");
        QTest::newRow("region") << QList<double>{0, -1.45, 0} << QByteArray("zone");
        QTest::newRow("floor") << QList<double>{-1.2, -1, 0} << QByteArray();
    }
    void whatTheMouseSays() {
        QFETCH(QList<double>, point);
        QFETCH(QByteArray, path);
        m_window->move(pixel({point[0], point[1], point[2]}));
        QCOMPARE(QByteArray::fromStdString(m_window->view().hints().hovered()), path);
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(&m_window->view(), &leave);
        QVERIFY(m_window->view().hints().hovered().empty());
    }

    /// In degrees and millimetres, from stop to stop; of the selected robot alone, whose name may begin like another's.
    void slidersOfJoints() {
        m_window->selection.select("cart_2.base");
        m_window->trigger("model.joints");
        auto* panel = m_window->panel->findChild<QWidget*>(QStringLiteral("jointPanel"));
        QVERIFY(panel && panel->isVisible());
        const auto rebuilt = [] { QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); };
        const auto slider = [&](const char* joint) {
            return panel->findChild<QSlider*>(QStringLiteral("joint.%1.0").arg(QLatin1String(joint)));
        };
        const auto number = [&](const char* joint) {
            return panel->findChild<QDoubleSpinBox*>(QStringLiteral("joint.%1.0.number").arg(QLatin1String(joint)));
        };
        QVERIFY(slider("mast") && number("arm"));
        QCOMPARE(slider("mast")->minimum(), -500);
        QCOMPARE(slider("mast")->maximum(), 2000);
        QCOMPARE(number("mast")->maximum(), 200.);
        QCOMPARE(slider("arm")->minimum(), -300);
        QCOMPARE(number("arm")->minimum(), -30.);
        QCOMPARE(number("mast")->suffix(), QStringLiteral(" mm"));
        auto* reset = panel->findChild<QPushButton*>(QStringLiteral("jointsReset"));
        QVERIFY(!reset->isEnabled());
        slider("mast")->setValue(1500);
        QCOMPARE(number("mast")->value(), 150.);
        QVERIFY((world().poseOf(*world().find("cart_2.lift")).position - Vec3(1.5, 0, 0.45)).norm() < 1e-9);
        QVERIFY((world().poseOf(*world().find("cart.lift")).position - Vec3(0, 0, 0.3)).norm() < 1e-9);
        number("arm")->setValue(-20);
        QCOMPARE(slider("arm")->value(), -200);
        QVERIFY(world()
                    .poseOf(*world().find("cart_2.wheel"))
                    .rotation.angularDistance(rotationFromHpr({0, -std::numbers::pi / 9, 0})) < 1e-6);
        QVERIFY(reset->isEnabled());
        m_window->selection.select("cart");
        rebuilt();
        QCOMPARE(slider("mast")->value(), 0);
        m_window->selection.select("cart_2");
        rebuilt();
        QCOMPARE(slider("mast")->value(), 1500);
        reset->click();
        QVERIFY(jointPositions(world()).empty() && slider("mast")->value() == 0 && !reset->isEnabled());
        m_window->trigger("model.joints");
    }

    /// What is drawn with a picture depends on the settings, on marks and on the camera.
    void whatAPictureShows() {
        View& view = m_window->view();
        ViewSettings& settings = m_window->panel->settings();
        const auto now = [&](bool fine = false) { return pictureRequest(view, fine, true); };
        QVERIFY(now().samples == 1 && now(true).samples == 4 && pictureRequest(view, false, false).samples == 4);
        QVERIFY((now().mask & kMaskGuide) && now().floorLines && (now().mask & kMaskShadows) && !(now().mask & kMaskSoftShadows));
        QVERIFY(now(true).mask & kMaskSoftShadows);
        settings.show(kOverlayWireframe, true);
        QVERIFY(now().wireframe && !(now().mask & (kMaskShadows | kMaskSoftShadows)));
        settings.show(kOverlayGrid, false);
        QVERIFY(!(now().mask & kMaskGuide) && !now().floorLines && !(now().mask & kMaskCollision));
        settings.show(kOverlayCollision, true);
        QVERIFY(now().mask & kMaskCollision);
        m_window->selection.select("cart.base");
        view.hints().setHovered("cart.base", {});
        QVERIFY(now().marks.selected == std::vector<std::string>{"cart/base"} && now().marks.hovered.empty());
        view.hints().setHovered("cart_2", {});
        QCOMPARE(now().marks.hovered, std::vector<std::string>{"cart_2"});
        world().setHidden({"wall"});
        QCOMPARE(now().hidden, std::vector<std::string>{"wall"});
        const PictureRequest still = stillRequest(view, 640, 480);
        QVERIFY(still.marks.selected.empty() && still.marks.hovered.empty() && !still.yields && still.hidden.size() == 1);
        QVERIFY(still.width == 640 && still.height == 480 && now().width == std::uint32_t(view.width()));
        view.camera().lookThrough("cart_2/eye"); // which does not see its own robot
        QCOMPARE(now().hidden, (std::vector<std::string>{"wall", "cart_2"}));
    }

    /// The cross closes a label only if it is also released there; a double click puts a moved one into the column again.
    void labelsArePressed() {
        PinnedValues& pinned = m_window->panel->pinned();
        pinned.set({"cart", "cart_2"}, true);
        const auto label = [&](const char* path) {
            for (const PinnedLabel& each : pinnedLabels(m_window->view()))
                if (each.path == path) return each;
            return PinnedLabel();
        };
        const QPointF cross = label("cart").close.center();
        m_window->drag(cross, cross + QPointF(200, 100));
        QVERIFY(pinned.contains("cart") && !pinned.pins()[0].position && m_window->selection.empty());
        const QPointF middle = label("cart_2").rect.center();
        m_window->drag(middle, middle + QPointF(300, 90));
        QVERIFY((label("cart_2").rect.center() - middle - QPointF(300, 90)).manhattanLength() < 2);
        QVERIFY(std::abs(pinned.pins()[1].position->y() - (middle.y() + 90) / m_window->view().height()) < 0.01);
        const QPointF at = label("cart_2").rect.center();
        QMouseEvent twice(QEvent::MouseButtonDblClick, at, m_window->view().mapToGlobal(at), Qt::LeftButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&m_window->view(), &twice);
        m_window->release(at);
        QVERIFY(!pinned.pins()[1].position);
        m_window->click(label("cart").close.center());
        QCOMPARE(pinned.paths(), std::vector<std::string>{"cart_2"});
    }
};

QTEST_MAIN(PickingTest)
#include "picking_test.moc"
