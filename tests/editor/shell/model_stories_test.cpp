// Stories of the model editor from File > New, with mouse and keys alone: joints and their stops, connected bodies, aimed sensors, mass and
// balance, an arena that is driven through.

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QSlider>
#include <QSpinBox>
#include <QtTest>

#include "editor/document/document.h"
#include "editor/running/session.h"
#include "editor/shell/window_fixture.h"
#include "editor/shell/window_hand.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/gizmo/aim_shape.h"
#include "editor/viewport/gizmo/aim_tool.h"
#include "editor/viewport/gizmo/joint_tool.h"
#include "editor/viewport/view/view_tools.h"
#include "editor/viewport/view/viewport_panel.h"
#include "eventually.h"
#include "lang/formatter.h"

using namespace trundle;

namespace {

constexpr JointHandle kHighStop{JointHandle::Kind::Stop, {true, false}}, kAnchorHandle{JointHandle::Kind::Anchor, {}};

} // namespace

class ModelStoriesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_fixture.start(); }
    void init() {
        QSettings().clear();
        m_window = m_fixture.window();
        m_window->disableSettings();
        m_window->resize(1400, 900);
        m_window->show();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get())); // shortcuts work in the active window alone
    }
    void cleanup() { m_window.reset(); }

    /// An arm is put on, its stop dragged, its joint moved by the slider; what it rests on and its motor are shown.
    void anArmWithItsStops() {
        const WindowHand hand(*m_window);
        newModel(hand);
        hand.look({1, -1, 0.6}, {0.1, 0, 0.1});
        QVERIFY(hand.dragToPoint(QStringLiteral("Lifting arm"), {0.15, 0, 0.1}));
        QCOMPARE(selected(), QStringLiteral("RobotConfig.MyRobot.arm"));
        const QByteArray built = text();
        QVERIFY2(isClean(), built.constData());
        hand.look({0.25, -1.2, 0.25}, {0.15, 0, 0.1}); // from its side
        QVERIFY(hand.clickRow("RobotConfig.MyRobot.shoulder"));
        savePicture("joint_handles");
        const QPointF stop = handleAt(kHighStop), anchor = handleAt(kAnchorHandle);
        const double radius = QLineF(stop, anchor).length(), from = QLineF(anchor, stop).angle();
        hand.dragPixels(stop, anchor + QLineF::fromPolar(radius, from - 30).p2());
        QVERIFY2(text().contains("HighStop=40"), text().constData());
        QCOMPARE(entries(), std::size_t(3));

        QVERIFY(hand.choose({QStringLiteral("View"), QStringLiteral("Joint Positions")}));
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); // of sliders for another selection
        auto* slider = m_window->findChild<QSlider*>(QStringLiteral("joint.shoulder.0"));
        QVERIFY(slider && slider->isVisible());
        const QByteArray before = text();
        const double low = armTip();
        slider->setFocus();
        QTest::keyClick(slider, Qt::Key_End);
        QVERIFY2(armTip() > low + 0.05, QByteArray::number(armTip()));
        for (const char* overlay : {"Support Polygon", "Inertia", "Centres of Mass"})
            QVERIFY(hand.choose({QStringLiteral("View"), QStringLiteral("Overlays"), QLatin1String(overlay)}));
        hand.look({1, -1, 0.8}, {0.1, 0, 0.05});
        QVERIFY(hand.clickRow("RobotConfig.MyRobot"));
        savePicture("mass_overlay");
        QVERIFY(hand.clickRow("RobotConfig.MyRobot.armMotor"));
        savePicture("motor_curve");
        QCOMPARE(text(), before);
        m_window->viewport().views().current().setFocus();
        hand.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(text(), built);
    }

    /// A body is made by the menu, moved by the keys and joined to the chassis by a drag; its anchor snaps to the chassis.
    void bodiesAreConnectedByADrag() {
        const WindowHand hand(*m_window);
        newModel(hand);
        QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("Body")}));
        hand.look({0.7, -1.1, 0.8}, {0.1, 0, 0.1});
        view().setFocus();
        hand.key(Qt::Key_W); // Move
        for (int i = 0; i < 5; ++i) hand.key(Qt::Key_Right);
        const QByteArray moved = text();
        const double z = m_window->document().loaded()->experiment->robots.at(0).config->bodies.at(1).pose.position.z();
        hand.key(Qt::Key_J);
        hand.dragPoints({0.1, -0.1, 0.09}, {0.25, -0.05, z});
        savePicture("connected");
        QVERIFY2(text().contains("Hinge "), text().constData());
        QVERIFY2(isClean(), text().constData());
        const QByteArray joined = text();
        hand.dragPixels(handleAt(kAnchorHandle), hand.pixelOf({0.15, 0, 0.09}));
        QVERIFY2(text().contains("Anchor=0.15,0,0.09"), text().constData());
        hand.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(text(), joined);
        hand.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(text(), moved);
    }

    /// A camera on top, turned by an edge of its frustum and rolled; each is one undo.
    void aCameraIsAimed() {
        const WindowHand hand(*m_window);
        newModel(hand);
        hand.look({0.9, -0.9, 0.9}, {0, 0, 0.1});
        openSection(hand, 7); // devices
        QVERIFY(hand.dragToPoint(QStringLiteral("Camera"), {0.1, 0, 0.14}));
        const QByteArray dropped = text();
        QVERIFY2(isClean(), dropped.constData());
        const std::string camera = m_window->selection().current();
        const auto lines = aimShapeOf(view(), camera);
        QVERIFY(!lines.empty());
        hand.look({0.1, -0.01, 2.2}, {0.1, 0, 0.14}); // from above
        const Vec3 eye = lines[0][0], edge = (lines[0][1] - lines[0][0]).normalized();
        const auto turned = [&](double degrees) {
            return Vec3(eye + 0.5 * (Quat(Eigen::AngleAxisd(degrees * M_PI / 180, Vec3::UnitZ())) * edge));
        };
        hand.dragPixels(hand.pixelOf(turned(0)), hand.pixelOf(turned(30)));
        savePicture("camera_aimed");
        QVERIFY2(text().contains("HPR=30,0,0"), text().constData());
        QVERIFY2(isClean(), text().constData());
        const QByteArray aimed = text();
        hand.look({1.2, 0.7, 0.3}, {0.1, 0, 0.2}); // from ahead
        const auto roll = view().tools().aim().rollSpot();
        QVERIFY(roll);
        hand.dragPixels(*roll, *roll + QPointF(-40, 20));
        savePicture("camera_rolled");
        QVERIFY2(text().contains("HPR=30,0,") && text() != aimed, text().constData());
        hand.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(text(), aimed);
        hand.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(text(), dropped);
    }

    /// A room drawn with a ramp, a mark, a line and obstacles in it; a robot from the Library drives there.
    void anArenaToDriveThrough() {
        const WindowHand hand(*m_window);
        QVERIFY(hand.choose({QStringLiteral("File"), QStringLiteral("New"), QStringLiteral("Empty File")}));
        EVENTUALLY(m_window->isSettled()); // the Library has read its folders
        hand.look({0, -5, 6}, {0, 0, 0});
        QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("Draw Room")}));
        hand.dragPoints({-2, -1.5, 0}, {2, 1.5, 0});
        QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("Draw Line on the Floor")}));
        hand.clickPoint({-1.5, -1, 0});
        hand.clickPoint({-0.5, -1, 0});
        hand.key(Qt::Key_Return);
        hand.key(Qt::Key_Escape);
        QVERIFY(hand.dragToPoint(QStringLiteral("SimpleRobot"), {-1, 0, 0}));
        for (const auto& [object, place] : {std::pair("Ramp", Vec3(0.6, -1, 0)), {"FloorMark", Vec3(0.5, 0, 0)}})
            QVERIFY2(hand.dragToPoint(QLatin1String(object), place), object);
        QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("Obstacle Field")}));
        WindowHand::typeOver(m_window->findChild<QSpinBox*>(QStringLiteral("fieldCount")), QStringLiteral("5"));
        WindowHand::typeOver(m_window->findChild<QWidget*>(QStringLiteral("fieldLength"))->findChild<QLineEdit*>(),
                             QStringLiteral("3.9"));
        WindowHand::typeOver(m_window->findChild<QWidget*>(QStringLiteral("fieldWidth"))->findChild<QLineEdit*>(),
                             QStringLiteral("2.9"));
        QVERIFY(hand.press("fieldInsert"));
        savePicture("arena_built");
        QVERIFY2(isClean(), text().constData());
        QCOMPARE(entries(), std::size_t(6));
        RunSession& session = m_window->session();
        hand.key(Qt::Key_F5);
        EVENTUALLY(session.results().time() > 0.5);
        hand.key(Qt::Key_F6);
        const QByteArray built = text();
        for (int i = 0; i < 6; ++i) hand.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(text(), QByteArray());
        for (int i = 0; i < 6; ++i) hand.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(text(), built);
    }

private:
    void newModel(const WindowHand& hand) {
        QVERIFY(hand.choose({QStringLiteral("File"), QStringLiteral("New"), QStringLiteral("Empty File")}));
        EVENTUALLY(m_window->isSettled()); // the Library has read its folders
        QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("New Robot Model")}));
    }
    /// Of the Library.
    void openSection(const WindowHand& hand, int section) {
        const QByteArray number = QByteArray::number(section);
        const auto* list = m_window->findChild<QWidget*>(QLatin1String("libraryList." + number));
        QVERIFY(list);
        if (!list->isVisible()) QVERIFY(hand.press(("librarySection." + number).constData()));
    }
    [[nodiscard]] View& view() { return m_window->viewport().views().current(); }
    [[nodiscard]] QPointF handleAt(const JointHandle& handle) {
        return view().tools().joint().spot(handle).value_or(QPointF(-1, -1));
    }
    /// m, the height of the end of the arm as it is shown.
    [[nodiscard]] double armTip() {
        const ViewportScene& world = m_window->viewport().world();
        return (world.poseOf(*world.find("RobotConfig.MyRobot.arm")) * Vec3(0.2, 0, 0)).z();
    }
    [[nodiscard]] std::size_t entries() const { return m_window->document().edits().history().entries().size(); }
    [[nodiscard]] QString selected() const { return QString::fromStdString(m_window->selection().current()); }
    [[nodiscard]] QByteArray text() const {
        return QByteArray::fromStdString(*m_window->document().texts().text(m_window->document().texts().files().front()));
    }
    /// Without problems, and as the formatter would write it.
    [[nodiscard]] bool isClean() const {
        return m_window->document().loaded()->diagnostics.all().empty() &&
               format(*m_window->document().loaded()->trees[0]) == text().toStdString();
    }
    void savePicture(const char* name, QWidget* widget = nullptr) { WindowFixture::savePicture(*m_window, name, widget); }

    WindowFixture m_fixture;
    std::unique_ptr<MainWindow> m_window;
};

QTEST_MAIN(ModelStoriesTest)
#include "model_stories_test.moc"
