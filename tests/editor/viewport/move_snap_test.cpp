// The gizmo moves a body or shape to the faces, centres and mirror images of the rest of its model.
#include <QDir>
#include <QtTest>

#include "editor/viewport/gizmo_hand.h"
#include "eventually.h"

using namespace trundle;

namespace {

constexpr GizmoHandle kMoveX{GizmoHandle::Kind::Axis, 0}, kMoveY{GizmoHandle::Kind::Axis, 1}, kMoveZ{GizmoHandle::Kind::Axis, 2},
    kPlaneZ{GizmoHandle::Kind::Plane, 2};

// The hull: x -0.187 to 0.213, y -0.1 to 0.1, z 0.05 to 0.13. The lid: 0.1 x 0.06 x 0.02.
const QByteArray kKit =
    "RobotConfig Kit {\n"
    "  Body chassis { Box hull { Size=0.4,0.2,0.08 Pos=0.013,0,0.09 Mass=1 } }\n"
    "  Body leftWheel { Pos=0.0623,0.122,0.05 Cylinder tyre { Radius=0.05 Length=0.03 HPR=0,0,90 Mass=0.1 } }\n"
    "  Body rightWheel { Pos=-0.11,-0.2,0.05 Cylinder tyre { Radius=0.05 Length=0.03 HPR=0,0,90 Mass=0.1 } }\n"
    "  Body lid { Pos=0.08,0.05,0.24 Box cover { Size=0.1,0.06,0.02 Mass=0.1 } }\n"
    "  Body knob { In=lid Pos=0,0,0.03 Box b { Size=0.02,0.02,0.04 Mass=0.1 } }\n"
    "}\nRobot kit { Config=Kit }\n";

} // namespace

class MoveSnapTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_render = RenderService::startInBackground(); }
    void init() {
        m_window = std::make_unique<ViewWindow>(m_render.get());
        open(kKit);
    }
    void cleanup() { m_window.reset(); }

    void drags_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<GizmoHandle>("handle");
        QTest::addColumn<Vec3>("origin");
        QTest::addColumn<Vec3>("by");
        QTest::addColumn<QByteArray>("written");
        const Vec3 lid(0.08, 0.05, 0.24), right(-0.11, -0.2, 0.05);
        QTest::newRow("on the chassis") << "kit.lid" << kMoveZ << lid << Vec3(0, 0, -0.097)
                                        << QByteArray("lid { Pos=0.08,0.05,0.14 ");
        QTest::newRow("flush with its side")
            << "kit.lid" << kMoveY << lid << Vec3(0, 0.017, 0) << QByteArray("lid { Pos=0.08,0.07,0.24 ");
        QTest::newRow("centred on it") << "kit.lid" << kMoveX << lid << Vec3(-0.064, 0, 0)
                                       << QByteArray("lid { Pos=0.013,0.05,0.24 ");
        QTest::newRow("on the axis of the model")
            << "kit.lid" << kMoveY << lid << Vec3(0, -0.047, 0) << QByteArray("lid { Pos=0.08,0,0.24 ");
        QTest::newRow("beside the other wheel")
            << "kit.rightWheel" << kMoveX << right << Vec3(0.17, 0, 0) << QByteArray("rightWheel { Pos=0.0623,-0.2,0.05 ");
        QTest::newRow("opposite of it") << "kit.rightWheel" << kMoveY << right << Vec3(0, 0.0755, 0)
                                        << QByteArray("rightWheel { Pos=-0.11,-0.122,0.05 ");
        QTest::newRow("opposite and beside") << "kit.rightWheel" << kPlaneZ << right << Vec3(0.171, 0.077, 0)
                                             << QByteArray("rightWheel { Pos=0.0623,-0.122,0.05 ");
        QTest::newRow("along two axes") << "kit.lid" << kPlaneZ << lid << Vec3(-0.0645, 0.0175, 0)
                                        << QByteArray("lid { Pos=0.013,0.07,0.24 ");
        QTest::newRow("in steps, far from all")
            << "kit.lid" << kMoveZ << lid << Vec3(0, 0, 0.148) << QByteArray("lid { Pos=0.08,0.05,0.39 ");
        QTest::newRow("a shape of the chassis") << "kit.chassis.hull" << kMoveX << Vec3(0.013, 0, 0.09) << Vec3(-0.0135, 0, 0)
                                                << QByteArray("Box hull { Size=0.4,0.2,0.08 Pos=0,0,0.09 ");
        QTest::newRow("in the config") << "RobotConfig.Kit.lid" << kMoveZ << lid << Vec3(0, 0, -0.097)
                                       << QByteArray("Body lid { Pos=0.08,0.05,0.14 ");
    }
    void drags() {
        QFETCH(QString, path);
        QFETCH(GizmoHandle, handle);
        QFETCH(Vec3, origin);
        QFETCH(Vec3, by);
        QFETCH(QByteArray, written);
        drag(path.toStdString(), handle, by, origin);
        QVERIFY2(m_window->text().contains(written), m_window->text().constData());
        QCOMPARE(m_window->document.edits().history().entries().size(), std::size_t(1));
        m_window->document.edits().undo();
        QCOMPARE(m_window->text(), kKit);
    }

    void withoutSnapping() {
        const Vec3 lid(0.08, 0.05, 0.24), by(0, 0, -0.097);
        const auto isExact = [&] { return std::abs(heightOfLid() - 0.143) < 0.0015 && std::abs(heightOfLid() - 0.14) > 0.0015; };
        drag("kit.lid", kMoveZ, by, lid, Qt::ControlModifier);
        QVERIFY2(isExact(), m_window->text().constData());
        m_window->document.edits().undo();
        m_window->trigger("tool.snap");
        drag("kit.lid", kMoveZ, by, lid);
        QVERIFY2(isExact(), m_window->text().constData());
        m_window->document.edits().undo();
        drag("kit.lid", kMoveZ, by, lid, Qt::ShiftModifier); // and on again
        QVERIFY2(std::abs(heightOfLid() - 0.14) < 1e-9, m_window->text().constData());
        m_window->trigger("tool.snap");
    }

    /// Steps that are seen close together leave room for what is near.
    void fineSteps() {
        m_window->panel->settings().setSteps(0.001, 15);
        drag("kit.lid", kMoveX, {-0.0655, 0, 0}, {0.08, 0.05, 0.24});
        QVERIFY2(m_window->text().contains("lid { Pos=0.013,0.05,0.24 "), m_window->text().constData());
        m_window->document.edits().undo();
        drag("kit.lid", kMoveZ, {0, 0, 0.0487}, {0.08, 0.05, 0.24});
        QVERIFY2(std::abs(heightOfLid() - 0.289) < 1e-9, m_window->text().constData());
    }

    /// By the distance in the picture: what is within 14 pixels.
    void fromNearLessIsNear() {
        m_window->look({0.08, -0.3, 0.35}, {0.08, 0.05, 0.2});
        m_window->panel->settings().setSteps(0.001, 15);
        drag("kit.lid", kMoveZ, {0, 0, -0.092}, {0.08, 0.05, 0.24});
        QVERIFY2(std::abs(heightOfLid() - 0.148) < 1e-9, m_window->text().constData());
    }

    /// A typed number is taken as it is.
    void typedNumbers() {
        take("kit.lid");
        const QPointF from = *m_window->view().tools().gizmo().spot(kMoveZ);
        m_window->press(from);
        m_window->move(from + QPointF(0, 20), {}, Qt::LeftButton);
        m_window->type(QStringLiteral("-0.099"));
        m_window->move(from + QPointF(0, 21), {}, Qt::LeftButton);
        m_window->key(Qt::Key_Return);
        m_window->release(from);
        QVERIFY2(std::abs(heightOfLid() - 0.141) < 1e-9, m_window->text().constData());
    }

    /// While it is dragged, and not after.
    void guidesAreShown() {
        take("kit.lid");
        const QPointF from = *m_window->view().tools().gizmo().spot(kMoveZ), to = from + way({0.08, 0.05, 0.24}, {0, 0, -0.097});
        m_window->press(from);
        m_window->move(from + (to - from) / 2, {}, Qt::LeftButton);
        m_window->move(to, {}, Qt::LeftButton);
        EVENTUALLY(m_window->panel->isSettled() && std::abs(heightOfLid() - 0.14) < 1e-9);
        const QImage during = m_window->view().grab().toImage();
        if (const QString folder = qEnvironmentVariable("TRUNDLE_PICTURES"); !folder.isEmpty())
            during.save(QDir(folder).filePath(QStringLiteral("move_snap.png")));
        const auto greenAt = [&](const QImage& image) { // along the front edge of the plane, right of the lid
            int green = 0;
            for (double x = -0.1; x < 0.2; x += 0.001) {
                const QColor c = image.pixelColor(m_window->at({x, -0.1, 0.13}));
                green += c.green() > c.red() + 60 && c.green() > c.blue() + 40;
            }
            return green;
        };
        QVERIFY2(greenAt(during) > 40, qPrintable(QString::number(greenAt(during))));
        m_window->release(to);
        EVENTUALLY(m_window->panel->isSettled());
        QCOMPARE(greenAt(m_window->view().grab().toImage()), 0);
    }

    /// In the model editor, and in a robot that is turned.
    void inTheModelEditor() {
        open("RobotConfig Kit {\n  Body chassis { Box hull { Size=0.4,0.2,0.08 Pos=0,0,0.09 Mass=1 } }\n"
             "  Body lid { Pos=0.08,0.05,0.24 Box cover { Size=0.1,0.06,0.02 Mass=0.1 } }\n}\nRobot kit { Config=Kit HPR=30,0,0 "
             "}\n");
        m_window->document.editedModel().open("RobotConfig.Kit");
        m_window->look({0.25, -0.9, 0.6}, {0, 0, 0.1});
        const double lift = m_window->panel->world().poseOf(*m_window->panel->world().find("RobotConfig.Kit")).position.z();
        drag("RobotConfig.Kit.lid", kMoveY, {0, 0.0165, 0}, {0.08, 0.05, 0.24 + lift});
        QVERIFY2(m_window->text().contains("Body lid { Pos=0.08,0.07,0.24 "), m_window->text().constData());
        m_window->document.edits().undo();
        m_window->document.editedModel().close();
        m_window->look({0.25, -0.9, 0.6}, {0, 0, 0.1});
        m_window->panel->settings().setAxes(AxesOf::Local);
        const Quat turn = rotationFromHpr({M_PI / 6, 0, 0});
        drag("kit.lid", kMoveY, turn * Vec3(0, 0.0165, 0), turn * Vec3(0.08, 0.05, 0.24));
        QVERIFY2(m_window->text().contains("Body lid { Pos=0.08,0.07,0.24 "), m_window->text().constData());
    }

    /// Scenery has no bodies.
    void shapesOfScenery() {
        open("StaticConfig Yard {\n  Box wall { Size=1,0.1,0.3 Pos=0,0.313,0.15 }\n  Box crate { Size=0.2,0.2,0.2 Pos=0,-0.1,0.1 "
             "}\n}\n"
             "Static yard { Config=Yard }\n");
        m_window->look({0.5, -1.2, 0.9}, {0, 0, 0.1});
        drag("StaticConfig.Yard.crate", kMoveY, {0, 0.265, 0}, {0, -0.1, 0.1});
        QVERIFY2(m_window->text().contains("Box crate { Size=0.2,0.2,0.2 Pos=0,0.163,0.1 }"), m_window->text().constData());
    }

private:
    void open(const QByteArray& text) {
        QVERIFY(m_window->open(text));
        m_window->look({0.25, -0.9, 0.6}, {0, 0, 0.1});
        m_window->view().setFocus();
    }
    void take(const std::string& path) {
        m_window->selection.select(path);
        m_window->trigger("tool.move");
    }
    void drag(const std::string& path, const GizmoHandle& handle, const Vec3& by, const Vec3& origin,
              Qt::KeyboardModifiers modifiers = {}) {
        take(path);
        QVERIFY(dragHandle(*m_window, handle, by, origin, modifiers));
    }
    /// In the picture, from a point in W.
    QPointF way(const Vec3& from, const Vec3& by) {
        const CameraControl& camera = m_window->view().camera();
        return *camera.pixelOf(from + by) - *camera.pixelOf(from);
    }
    double heightOfLid() const {
        for (const BodySpec& body : m_window->document.loaded()->experiment->robots.at(0).config->bodies)
            if (body.name == "lid") return body.pose.position.z();
        return 0;
    }

    std::unique_ptr<RenderService> m_render;
    std::unique_ptr<ViewWindow> m_window;
};

QTEST_MAIN(MoveSnapTest)
#include "move_snap_test.moc"
