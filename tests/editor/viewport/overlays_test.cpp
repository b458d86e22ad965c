// What is drawn over a 3D view, compared with computed places: springs, frusta, beams, joints, regions, names, mass, scales.
#include <numbers>

#include <QPainter>
#include <QtTest>

#include "editor/viewport/context/joint_positions.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/overlays/beams.h"
#include "editor/viewport/overlays/frusta.h"
#include "editor/viewport/overlays/mass_overlay.h"
#include "editor/viewport/overlays/overlays.h"
#include "editor/viewport/overlays/pinned_values.h"
#include "editor/viewport/overlays/regions.h"
#include "editor/viewport/overlays/springs.h"
#include "editor/viewport/paint_record.h"
#include "editor/viewport/view_window.h"
#include "editor/widgets/theme.h"

using namespace trundle;

namespace {

using Drawn = PaintedShape::Kind;
const QColor kSteel(196, 204, 214), kFrustum(70, 196, 222), kBeam(226, 68, 92), kJoint(214, 92, 214), kLight(245, 246, 248);

/// Two turned robots at different places, each of two bodies; the hinge turns the second one about y through kAnchor.
const QByteArray kArms = R"(Tick = 0.01
RobotConfig Arm {
  Body base { Box hull { Size=0.2,0.1,0.1 Pos=0,0,0.05 Mass=2 } }
  Body rod { Pos=0.1,0,0.4 HPR=0,30,0 Box bar { Size=0.05,0.05,0.4 Pos=0,0,0.1 Mass=0.05 } }
  Hinge elbow { Parent=base Child=rod Anchor=0.1,0,0.2 Axis=0,1,0 }
  Spring coil { Parent=base Child=rod Anchor=0.15,0.02,0.12 Anchor2=0.05,0.01,0.6 Length=0.3 Stiffness=10 }
  Spring hook { Parent=world Child=rod Anchor=0.4,0,0.7 Anchor2=0.1,0.03,0.5 Length=0.2 Stiffness=10 }
  Camera eye { Body=rod Pos=0.05,0,0.1 HPR=40,0,0 Resolution=40,20 FieldOfView=60 Near=0.1 Far=0.5 }
  RangeSensor echo { Body=rod Pos=0,0.03,0 HPR=90,0,0 Type=ultrasonic MinRange=0.02 MaxRange=0.4 }
  Lidar scan { Body=rod Pos=0,0,0.2 HPR=0,0,90 Beams=3 FieldOfView=60 MinRange=0.02 MaxRange=0.5 }
}
Robot near { Config=Arm Pos=-0.4,0.3,0 HPR=30,0,0 }
Robot far { Config=Arm Pos=0.7,-0.2,0.1 HPR=-70,0,0 }
Spring tie { Parent=near.rod Child=far.base Anchor=-0.3,0.3,0.5 Anchor2=0.6,-0.2,0.2 Length=0.5 Stiffness=10 }
Spring wire { Parent=world Child=far.rod Anchor=0.2,0.6,0.3 Anchor2=0.7,-0.2,0.6 Length=0.5 Stiffness=10 }
Hinge pin { Parent=near.base Child=far.base Anchor=0.5,0,0.3 Axis=0,0,1 }
Region zone { Pos=0.2,0.5,0.3 HPR=25,0,0 Size=0.6,0.2,0.4 }
Region strip { Pos=-0.5,-0.6,0.1 Size=0.2,0.8,0.2 }
)";
constexpr double kTurned = 0.6; // rad, of near.elbow
const Pose kNear{Vec3(-0.4, 0.3, 0), rotationFromHpr({std::numbers::pi / 6, 0, 0})},
    kFar{Vec3(0.7, -0.2, 0.1), rotationFromHpr({-70 * std::numbers::pi / 180, 0, 0})};
const Vec3 kAnchor(0.1, 0, 0.2);
const Quat kBend(Eigen::AngleAxisd(kTurned, Vec3::UnitY()));

/// Where a point of near.rod is in W, described at the start in the frame of the config.
Vec3 onNearRod(const Vec3& p_C) { return kNear * Vec3(kAnchor + kBend * (p_C - kAnchor)); }

} // namespace

class OverlaysTest : public QObject {
    Q_OBJECT

    std::unique_ptr<ViewWindow> m_window;

    ViewportScene& world() { return m_window->panel->world(); }
    QPointF pixel(const Vec3& point) { return *m_window->view().camera().pixelOf(point); }
    template <class Paint> PaintRecord painted(Paint paint) {
        PaintRecord record(m_window->view().size());
        QPainter painter(&record);
        paint(painter);
        painter.end();
        return record;
    }
    PaintRecord overlays() {
        return painted([this](QPainter& painter) { paintOverlays(painter, m_window->view()); });
    }
    /// Whether a polyline of this colour leads from one point to another.
    bool hasCoil(const PaintRecord& record, const Vec3& from, const Vec3& to, const QColor& colour = kSteel) {
        return std::ranges::any_of(record.of(Drawn::Polyline, colour), [&](const PaintedShape& coil) {
            return coil.points.size() == 83 && (coil.points.front() - pixel(from)).manhattanLength() < 0.01 &&
                   (coil.points.back() - pixel(to)).manhattanLength() < 0.01;
        });
    }

private Q_SLOTS:
    void init() {
        m_window = std::make_unique<ViewWindow>(nullptr); // without pictures: what is drawn is where the camera sees it
        QVERIFY(m_window->open(kArms));
        QVERIFY2(!m_window->document.loaded()->diagnostics.hasErrors(), "the text has errors");
        m_window->look({1.2, -2.6, 1.9}, {0.1, 0.1, 0.3});
        jointPositions(world()).set(world().objects()->experiment().robots[0], 0, kTurned);
    }
    void cleanup() { m_window.reset(); }

    /// They move with the bodies that they join; those to the world begin at a fixed place.
    void springsAreWhereTheirBodiesAre() {
        const auto paint = [this] { return painted([this](QPainter& p) { paintSprings(p, m_window->view()); }); };
        const PaintRecord record = paint();
        QCOMPARE(record.of(Drawn::Polyline, kSteel).size(), std::size_t(6));
        QVERIFY(hasCoil(record, kNear * Vec3(0.15, 0.02, 0.12), onNearRod({0.05, 0.01, 0.6})));
        QVERIFY(hasCoil(record, kNear * Vec3(0.4, 0, 0.7), onNearRod({0.1, 0.03, 0.5})));
        QVERIFY(hasCoil(record, kFar * Vec3(0.15, 0.02, 0.12), kFar * Vec3(0.05, 0.01, 0.6)));
        QVERIFY(hasCoil(record, kFar * Vec3(0.4, 0, 0.7), kFar * Vec3(0.1, 0.03, 0.5)));
        QVERIFY(hasCoil(record, onNearRod(kNear.inverse() * Vec3(-0.3, 0.3, 0.5)), {0.6, -0.2, 0.2}));
        QVERIFY(hasCoil(record, {0.2, 0.6, 0.3}, {0.7, -0.2, 0.6}));
        m_window->selection.select("near.coil");
        QVERIFY(hasCoil(paint(), kNear * Vec3(0.15, 0.02, 0.12), onNearRod({0.05, 0.01, 0.6}), ToolView::outlineColour()));
        QCOMPARE(paint().of(Drawn::Polyline, ToolView::outlineColour()).size(), std::size_t(1));
        m_window->selection.select("tie");
        QVERIFY(hasCoil(paint(), onNearRod(kNear.inverse() * Vec3(-0.3, 0.3, 0.5)), {0.6, -0.2, 0.2}, ToolView::outlineColour()));
        m_window->selection.select("RobotConfig.Arm.hook"); // of both robots
        QCOMPARE(paint().of(Drawn::Polyline, ToolView::outlineColour()).size(), std::size_t(2));
        m_window->selection.clear();
        world().setHidden({"near"});
        QCOMPARE(paint().of(Drawn::Polyline, kSteel).size(), std::size_t(4)); // without its own two
    }

    /// As thick as 6 % of the length of the spring, from 3 mm to 3 cm.
    void coilsAreAsThickAsTheirSpringsAreLong_data() {
        QTest::addColumn<QByteArray>("length");
        QTest::addColumn<double>("radius");
        QTest::newRow("short") << QByteArray("0.01") << 0.003;
        QTest::newRow("between") << QByteArray("0.3") << 0.018;
        QTest::newRow("long") << QByteArray("2") << 0.03;
    }
    void coilsAreAsThickAsTheirSpringsAreLong() {
        QFETCH(QByteArray, length);
        QFETCH(double, radius);
        QVERIFY(m_window->open("RobotConfig C { Body b { Box x { Size=0.1,0.1,0.1 Mass=1 } } }\nRobot r { Config=C }\n"
                               "Spring s { Parent=world Child=r.b Anchor=-0.4,0,0.3 Anchor2=0.4,0,0.3 Length=" +
                               length + " Stiffness=1 }\n"));
        m_window->trigger("view.top"); // parallel: the whole width is seen
        m_window->view().frame(world().bounds(), false);
        const PaintRecord record = painted([this](QPainter& p) { paintSprings(p, m_window->view()); });
        const auto coils = record.of(Drawn::Polyline, kSteel);
        QCOMPARE(coils.size(), std::size_t(1));
        double most = 0;
        for (const QPointF& point : coils[0].points) most = std::max(most, std::abs(point.y() - coils[0].points.front().y()));
        const double metres = m_window->view().camera().free().metresPerPixel(m_window->view().width(), Vec3::Zero());
        QVERIFY2(std::abs(most * metres - radius) < 0.03 * radius, QByteArray::number(most * metres));
    }

    /// Twelve edges between the near and the far plane, of a lens that is twice as wide as high.
    void edgesOfFrusta() {
        const auto paint = [this](bool all) {
            return painted([this, all](QPainter& p) { paintFrusta(p, m_window->view(), all); });
        };
        const auto corner = [](double depth, int i) {
            const double wide = std::tan(std::numbers::pi / 6) * depth, y = i == 0 || i == 3 ? wide : -wide,
                         z = (i < 2 ? 0.5 : -0.5) * wide;
            const Quat lens = rotationFromHpr({0, std::numbers::pi / 6, 0}),
                       eye = rotationFromHpr({40 * std::numbers::pi / 180, 0, 0});
            return onNearRod(Vec3(0.1, 0, 0.4) + lens * (Vec3(0.05, 0, 0.1) + eye * Vec3(depth, y, z)));
        };
        const PaintRecord record = paint(true);
        for (int i = 0; i < 4; ++i) {
            QVERIFY(record.hasLine(pixel(corner(0.1, i)), pixel(corner(0.5, i)), kFrustum));
            for (const double depth : {0.1, 0.5})
                QVERIFY(record.hasLine(pixel(corner(depth, i)), pixel(corner(depth, (i + 1) % 4)), kFrustum));
        }
        QCOMPARE(record.of(Drawn::Line, kFrustum).size(), std::size_t(24));
        QVERIFY(paint(false).of(Drawn::Line).empty());
        m_window->selection.select("near.eye");
        QCOMPARE(paint(false).of(Drawn::Line, ToolView::outlineColour()).size(), std::size_t(12));
        QCOMPARE(paint(true).of(Drawn::Line, kFrustum).size(), std::size_t(12)); // of the other
        world().setHidden({"near"});
        QVERIFY(paint(false).of(Drawn::Line).empty());
        world().setHidden({});
        m_window->view().camera().lookThrough("near/eye"); // its own frustum would hide the picture
        QVERIFY(paint(true).of(Drawn::Line, ToolView::outlineColour()).empty());
    }

    /// A cone of 30 degrees about x; a fan from the sensor to the ends of its beams.
    void beamsEndWhereTheyReach() {
        const auto paint = [this] { return painted([this](QPainter& p) { paintBeams(p, m_window->view(), true); }); };
        const Quat rod = rotationFromHpr({0, std::numbers::pi / 6, 0});
        const auto onRod = [&](const Vec3& p_B) { return onNearRod(Vec3(0.1, 0, 0.4) + rod * p_B); };
        const auto rim = [&](double around) { // the sensor looks along y of the body
            const double half = std::numbers::pi / 12;
            const Vec3 way(-std::sin(half) * std::cos(around), std::cos(half), std::sin(half) * std::sin(around));
            return onRod(Vec3(0, 0.03, 0) + 0.4 * way);
        };
        QColor edge = kBeam;
        edge.setAlpha(170);
        const PaintRecord record = paint();
        for (const double around : {0., 0.5, 1., 1.5})
            QVERIFY(record.hasLine(pixel(onRod({0, 0.03, 0})), pixel(rim(around * std::numbers::pi)), edge));
        QColor beam = kBeam;
        beam.setAlpha(150);
        for (const double degrees : {-30., 0., 30.}) { // rolled by 90 degrees: its y is up
            const double a = degrees * std::numbers::pi / 180;
            QVERIFY(record.hasLine(pixel(onRod({0, 0, 0.2})), pixel(onRod(Vec3(0.5 * std::cos(a), 0, 0.2 + 0.5 * std::sin(a)))),
                                   beam));
        }
        const auto fans = record.of(Drawn::Polygon);
        QVERIFY(std::ranges::any_of(fans, [&](const PaintedShape& fan) { // from the sensor, since it does not look all around
            return fan.points.size() == 4 && (fan.points[0] - pixel(onRod({0, 0, 0.2}))).manhattanLength() < 0.01;
        }));
        const std::size_t both = record.of(Drawn::Line, edge).size();
        world().setHidden({"far"});
        QCOMPARE(paint().of(Drawn::Line, edge).size(), both / 2);
    }

    /// An arrow along the axis, 26 pixels to both sides at the anchor; between robots it moves with the child.
    void jointsAreArrowsAlongTheirAxes() {
        m_window->trigger("view.overlayJoints");
        const auto hasArrow = [this](const Vec3& at, const Vec3& axis) {
            const View& view = m_window->view();
            const double reach = 26 * view.camera().free().metresPerPixel(view.width(), at);
            return overlays().hasLine(pixel(at - reach * axis), pixel(at + reach * axis), kJoint);
        };
        QVERIFY(hasArrow(kNear * kAnchor, kNear.rotation * Vec3::UnitY()));
        QVERIFY(hasArrow(kFar * kAnchor, kFar.rotation * Vec3::UnitY()));
        QVERIFY(hasArrow({0.5, 0, 0.3}, Vec3::UnitZ()));
        world().setHidden({"far"});
        QVERIFY(hasArrow(kNear * kAnchor, kNear.rotation * Vec3::UnitY()));
        QVERIFY(!hasArrow(kFar * kAnchor, kFar.rotation * Vec3::UnitY()) && !hasArrow({0.5, 0, 0.3}, Vec3::UnitZ()));
    }

    /// Their faces, and a click near an edge of a turned one; between the ends of the edge only.
    void regionsAreTheirBoxes() {
        View& view = m_window->view();
        const Pose zone{Vec3(0.2, 0.5, 0.3), rotationFromHpr({25 * std::numbers::pi / 180, 0, 0})};
        const auto corner = [&](double x, double y, double z) { return pixel(zone * Vec3(0.3 * x, 0.1 * y, 0.2 * z)); };
        const auto faces = painted([&](QPainter& p) { paintRegions(p, view); }).of(Drawn::Polygon);
        const auto hasFace = [&](const QPolygonF& wanted) {
            return std::ranges::any_of(faces, [&](const PaintedShape& face) {
                return face.points.size() == 4 && std::ranges::all_of(wanted, [&](const QPointF& point) {
                           return std::ranges::any_of(face.points,
                                                      [&](const QPointF& p) { return (p - point).manhattanLength() < 0.01; });
                       });
            });
        };
        for (const double s : {-1., 1.}) {
            QVERIFY(hasFace({corner(s, -1, -1), corner(s, 1, -1), corner(s, 1, 1), corner(s, -1, 1)}));
            QVERIFY(hasFace({corner(-1, s, -1), corner(1, s, -1), corner(1, s, 1), corner(-1, s, 1)}));
            QVERIFY(hasFace({corner(-1, -1, s), corner(1, -1, s), corner(1, 1, s), corner(-1, 1, s)}));
        }
        for (const QPointF& at : {0.5 * (corner(1, 1, 1) + corner(1, 1, -1)), 0.5 * (corner(-1, -1, 1) + corner(1, -1, 1)),
                                  0.5 * (corner(1, -1, 1) + corner(1, 1, 1))}) {
            QCOMPARE(regionAt(view, at), std::string("zone"));
            QCOMPARE(regionAt(view, at + QPointF(0, 300)), std::string());
        }
        const QPointF along = corner(1, 1, 1) - corner(-1, 1, 1);
        QCOMPARE(regionAt(view, corner(1, 1, 1) + 0.3 * along), std::string());
        QCOMPARE(regionAt(view, pixel({-0.6, -0.6, 0.2})), std::string("strip"));
        const Bounds bounds = boundsOfRegions(world().objects()->experiment(), "zone");
        const double a = 25 * std::numbers::pi / 180;
        QVERIFY((bounds.centre() - zone.position).norm() < 1e-9);
        QVERIFY((bounds.size() - Vec3(0.6 * std::cos(a) + 0.2 * std::sin(a), 0.6 * std::sin(a) + 0.2 * std::cos(a), 0.4)).norm() <
                1e-9);
    }

    /// Each name is centred over the top of its object.
    void namesAreOverTheirObjects() {
        m_window->trigger("view.overlayNames");
        const auto placesOf = [this](const char* name) {
            QList<QPointF> places;
            for (const PaintedShape& text : overlays().of(Drawn::Text, kLight))
                if (text.text == QLatin1String(name)) places << text.points[0];
            return places;
        };
        const double high =
            kFar.position.z() + 0.4 + 0.3 * std::cos(std::numbers::pi / 6) + 0.025 * std::sin(std::numbers::pi / 6);
        const Bounds far = world().boundsOf(*world().find("far"));
        QVERIFY(std::abs(far.high.z() - high) < 1e-9);
        const auto places = placesOf("far");
        QCOMPARE(places.size(), 1);
        const QPointF at = pixel({far.centre().x(), far.centre().y(), high});
        const double wide = QFontMetrics(m_window->view().font()).horizontalAdvance(QStringLiteral("far"));
        QVERIFY(std::abs(places[0].x() + 0.5 * wide - at.x()) < 3);
        QVERIFY(places[0].y() < at.y() && places[0].y() > at.y() - 20);
        world().setHidden({"far"});
        QVERIFY(placesOf("far").isEmpty() && placesOf("near").size() == 1);
    }

    /// Of bodies and, larger, of the whole; the inertia is labelled with the mass, in g below 0.1 kg.
    void centresOfMass() {
        View& view = m_window->view();
        const auto balls = painted([&](QPainter& p) { paintCentresOfMass(p, view); }).of(Drawn::Ellipse);
        const auto hasBall = [&](const Vec3& at, double radius) {
            return std::ranges::any_of(balls, [&](const PaintedShape& ball) {
                const QRectF box = ball.points.boundingRect();
                return (box.center() - pixel(at)).manhattanLength() < 0.01 && std::abs(box.width() - 2 * radius) < 1e-6;
            });
        };
        const Vec3 bar = Vec3(0.1, 0, 0.4) + rotationFromHpr({0, std::numbers::pi / 6, 0}) * Vec3(0, 0, 0.1), hull(0, 0, 0.05);
        QVERIFY(hasBall(kNear * hull, 3.2) && hasBall(onNearRod(bar), 3.2) && hasBall(kFar * bar, 3.2));
        QVERIFY(hasBall((2 * (kNear * hull) + 0.05 * onNearRod(bar)) / 2.05, 6.5));
        QCOMPARE(balls.size(), std::size_t(6));
        const auto labels = [&](const char* selected) {
            m_window->selection.select(selected);
            return painted([&](QPainter& p) { paintInertia(p, view); }).texts();
        };
        QCOMPARE(labels("near.base"), QStringList{QStringLiteral("2 kg")});
        QCOMPARE(labels("near.rod"), QStringList{QStringLiteral("50 g")});
        QCOMPARE(labels("near.rod.bar"), QStringList{QStringLiteral("50 g")});
        QCOMPARE(labels("far"), QStringList{QStringLiteral("2.05 kg")});
        QCOMPARE(labels("RobotConfig.Arm"), (QStringList{QStringLiteral("2.05 kg"), QStringLiteral("2.05 kg")}));
        world().setHidden({"far"});
        QVERIFY(labels("far").isEmpty());
        QCOMPARE(painted([&](QPainter& p) { paintCentresOfMass(p, view); }).of(Drawn::Ellipse).size(), std::size_t(3));
    }

    /// A solid box of 0.2 x 0.1 x 0.1 m has the ellipsoid of its inertia: semi-axes sqrt(5 / 12) times its sides.
    void ellipsoidsOfInertia() {
        View& view = m_window->view();
        m_window->trigger("view.top");
        view.frame(world().bounds(), false);
        m_window->selection.select("far.base");
        const auto rings = painted([&](QPainter& p) { paintInertia(p, view); }).of(Drawn::Polyline, QColor(90, 190, 255));
        QCOMPARE(rings.size(), std::size_t(3));
        const Vec3 centre = kFar * Vec3(0, 0, 0.05), x = kFar.rotation * Vec3::UnitX(), y = kFar.rotation * Vec3::UnitY();
        double along = 0, across = 0;
        const double metres = view.camera().free().metresPerPixel(view.width(), centre);
        for (const PaintedShape& ring : rings)
            for (const QPointF& point : ring.points) { // from above: x to the right, y upwards
                const QPointF by = metres * (point - pixel(centre));
                along = std::max(along, std::abs(by.x() * x.x() - by.y() * x.y()));
                across = std::max(across, std::abs(by.x() * y.x() - by.y() * y.y()));
            }
        QVERIFY2(std::abs(along - 0.2 * std::sqrt(5. / 12)) < 1e-3, QByteArray::number(along));
        QVERIFY2(std::abs(across - 0.1 * std::sqrt(5. / 12)) < 1e-3, QByteArray::number(across));
    }

    void scalesAndAxes_data() {
        QTest::addColumn<QByteArray>("action");
        QTest::addColumn<double>("zoom");
        for (const char* action : {"view.front", "view.side"})
            for (const double zoom : {0.02, 0.3, 1., 40., 900.})
                QTest::addRow("%s %g", action, zoom) << QByteArray(action) << zoom;
    }
    /// The bar is a round length and labelled with it; grid lines are at multiples of a round distance, the thick one on the ground.
    void scalesAndAxes() {
        QFETCH(QByteArray, action);
        QFETCH(double, zoom);
        View& view = m_window->view();
        m_window->trigger(action.constData());
        view.camera().change([&](ViewCamera& camera) {
            camera.pan(Vec3(0.37, 0.21, 0.13), Vec3::Zero());
            camera.zoom(zoom, camera.middle());
        });
        const ViewCamera& camera = view.camera().free();
        const double metres = camera.metresPerPixel(view.width(), camera.middle());
        const PaintRecord record = overlays();
        const auto bars = record.of(Drawn::Polyline, kLight);
        QCOMPARE(bars.size(), std::size_t(1));
        const double length = (bars[0].points[2].x() - bars[0].points[1].x()) * metres;
        const double digits = std::fmod(std::log10(length) + 12, 1); // of 1, 2 or 5
        QVERIFY(std::min({digits, std::abs(digits - std::log10(2)), std::abs(digits - std::log10(5)), 1 - digits}) < 1e-6);
        QString said;
        for (const QString& text : record.texts())
            if (text.endsWith(u'm')) said = text;
        const double unit = said.endsWith(QStringLiteral(" mm"))   ? 1e-3
                            : said.endsWith(QStringLiteral(" cm")) ? 1e-2
                            : said.endsWith(QStringLiteral(" km")) ? 1e3
                                                                   : 1;
        const double number = said.section(u' ', 0, 0).toDouble();
        QVERIFY2(std::abs(number * unit - length) < 1e-6 * length, qPrintable(said));
        QVERIFY2(number >= 1 && number < (unit == 1e-3 ? 10 : unit == 1e-2 ? 100 : 1000), qPrintable(said));
        const Vec3 right = cameraAxes(view.camera().view()).col(0);
        double step = 0;
        QList<double> upright, level;
        for (const PaintedShape& line : record.of(Drawn::Line, QColor(30, 40, 55, 34))) {
            const Vec3 at = view.camera().rayAt(line.points[0]).origin;
            (line.points[0].x() == line.points[1].x() ? upright : level)
                << (line.points[0].x() == line.points[1].x() ? right.dot(at) : at.z());
        }
        QVERIFY(upright.size() >= 3 && level.size() >= 3);
        step = upright[1] - upright[0];
        QVERIFY(step / metres > 50 && step / metres <= 130 + 1e-6);
        for (const double at : upright + level) QVERIFY(std::abs(at / step - std::round(at / step)) < 1e-4);
        const auto ground = record.of(Drawn::Line, QColor(30, 40, 55, 130));
        QCOMPARE(ground.size(), std::size_t(1));
        QVERIFY(std::abs(ground[0].points[0].y() - pixel({0, 0, 0}).y()) < 1e-6 || zoom < 0.1);
        QVERIFY(std::abs(view.camera().rayAt(ground[0].points[0]).origin.z()) < 1e-6);
    }

    /// The small axes at the lower left point where the world's do in the middle of the picture.
    void smallAxesPointAsTheWorlds() {
        View& view = m_window->view();
        const PaintRecord record = overlays();
        const Vec3 middle = view.camera().free().middle();
        const QPointF from(36, view.height() - 36);
        for (int axis = 0; axis < 3; ++axis) {
            const QPointF way = pixel(middle + 1e-4 * Vec3::Unit(axis)) - pixel(middle);
            const auto lines = record.of(Drawn::Line, ink(axis == 0 ? Ink::AxisX : axis == 1 ? Ink::AxisY : Ink::AxisZ));
            QCOMPARE(lines.size(), std::size_t(1));
            const QPointF by = lines[0].points[1] - from;
            QVERIFY((lines[0].points[0] - from).manhattanLength() < 1e-9);
            QVERIFY(QPointF::dotProduct(by, way) > 0.999 * std::hypot(by.x(), by.y()) * std::hypot(way.x(), way.y()));
        }
    }

    /// A line from the nearest point of the label to the object, if that is seen.
    void pinsPointAtTheirObjects() {
        PinnedValues& pinned = m_window->panel->pinned();
        pinned.set({"far", "far.rod"}, true);
        const QColor words(245, 246, 248);
        const auto leadsTo = [&](const Vec3& point) {
            const PaintRecord record = painted([this](QPainter& p) { paintPinnedValues(p, m_window->view()); });
            const auto lines = record.of(Drawn::Line, words);
            return std::ranges::any_of(lines, [&](const PaintedShape& line) {
                const bool fromEdge = std::ranges::any_of(pinnedLabels(m_window->view()), [&](const PinnedLabel& label) {
                    const QRectF& r = label.rect;
                    const QPointF edge(std::clamp(pixel(point).x(), r.left(), r.right()),
                                       std::clamp(pixel(point).y(), r.top(), r.bottom()));
                    return (edge - line.points[0]).manhattanLength() < 0.01;
                });
                return fromEdge && (line.points[1] - pixel(point)).manhattanLength() < 0.01;
            });
        };
        const Vec3 robot = world().boundsOf(*world().find("far")).centre(),
                   rod = world().boundsOf(*world().find("far.rod")).centre();
        QVERIFY(leadsTo(robot) && leadsTo(rod));
        pinned.move("far.rod", QPointF(0.8, 0.9));
        QVERIFY(leadsTo(robot) && leadsTo(rod));
        world().setHidden({"far"});
        QVERIFY(!leadsTo(robot) && !leadsTo(rod));
    }
};

QTEST_MAIN(OverlaysTest)
#include "overlays_test.moc"
