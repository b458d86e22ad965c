// A robot whose body is a mesh, with mouse and keys alone, from File > New to a drive: the mesh imported and fitted, wheels put on it, what the
// model check says of it, repaired, and driven.

#include <QComboBox>
#include <QLineEdit>
#include <QSettings>
#include <QTemporaryDir>
#include <QTreeView>
#include <QtTest>

#include "editor/document/document.h"
#include "editor/running/session.h"
#include "editor/shell/window_fixture.h"
#include "editor/shell/window_hand.h"
#include "editor/viewport/view/viewport_panel.h"
#include "eventually.h"
#include "lang/formatter.h"

using namespace trundle;

namespace {

/// A hull of 300 x 60 x 200 mm, y up, whose deck is smaller than its floor.
QByteArray hullObj() {
    QByteArray text = "o hull\n";
    for (const int y : {0, 60})
        for (const auto& [x, z] : {std::pair(0, 0), {300, 0}, {300, 200}, {0, 200}}) {
            const int in = y == 0 ? 0 : 20; // the deck is as much smaller at front and back
            text += "v " + QByteArray::number(x == 0 ? in : x - in) + ' ' + QByteArray::number(y) + ' ' + QByteArray::number(z) +
                    '\n';
        }
    for (const char* face : {"4 3 2 1", "5 6 7 8", "1 2 6 5", "2 3 7 6", "3 4 8 7", "4 1 5 8"})
        text += QByteArray("f ") + face + '\n';
    return text;
}

} // namespace

class MeshRobotTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        m_fixture.start();
        QFile file(m_elsewhere.filePath(QStringLiteral("hull.obj")));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(hullObj()) > 0);
    }
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

    void isImportedFittedCheckedAndDriven() {
        const WindowHand hand(*m_window);
        QVERIFY(hand.choose({QStringLiteral("File"), QStringLiteral("New"), QStringLiteral("Empty File")}));
        EVENTUALLY(m_window->isSettled()); // the Library has read its folders
        saveAs(hand, m_folder.filePath(QStringLiteral("barge.sim")));
        QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("New Robot Model")}));

        importHull(hand);
        QVERIFY2(text().contains("File=meshes/hull/hull.obj Scale=0.001"), text().constData());
        EVENTUALLY(isClean());                                      // once the mesh is read
        QVERIFY(hand.clickRow("RobotConfig.MyRobot.chassis.hull")); // the box that a new model begins with
        hand.key(Qt::Key_Delete);
        QVERIFY2(!text().contains("Box hull {"), text().constData());

        // Its parts are to be above the floor, as high as the axles of the wheels want it.
        QVERIFY(hand.clickRow("RobotConfig.MyRobot.chassis"));
        type("Pos", QStringLiteral("3 cm"), "field2");
        QVERIFY2(text().contains("    Pos=0,0,3 cm\n"), text().constData());

        hand.look({0.4, 1, 0.7}, {0, 0, 0.06});
        QVERIFY(hand.dragToPoint(QStringLiteral("Driven wheel"), {0.052, 0.1, 0.05}));
        hand.look({0.4, -1, 0.7}, {0, 0, 0.06});
        QVERIFY(hand.dragToPoint(QStringLiteral("Driven wheel"), {0.06, -0.1, 0.05}));
        QVERIFY(hand.dragToPoint(QStringLiteral("Slider"), {-0.11, 0.01, 0.09}));
        QVERIFY(hand.choose(
            {QStringLiteral("Insert"), QStringLiteral("Sensors and Actuators"), QStringLiteral("DifferentialDrive")}));
        EVENTUALLY(isClean());
        WindowFixture::savePicture(*m_window, "mesh_robot");

        // The check asks for a floor.
        QVERIFY(hand.press("modelDone"));
        EVENTUALLY(problems().size() == 1 && problems()[0].contains(QStringLiteral("no scenery")));
        QVERIFY(hand.dragToPoint(QStringLiteral("OpenFloor"), {0.8, 0.8, 0}));
        EVENTUALLY(text().contains("Config=OpenFloor"));
        EVENTUALLY(problems().isEmpty());
        // A wrong number in the drive is found; back, and it is gone.
        QVERIFY(hand.clickRow("RobotConfig.MyRobot.base"));
        type("WheelSeparation", QStringLiteral("0.3"));
        EVENTUALLY(problems().size() == 1 && problems()[0].contains(QStringLiteral("WheelSeparation of base is 300 mm")));
        m_window->viewport().views().current().setFocus();
        hand.key(Qt::Key_Z, Qt::ControlModifier);
        EVENTUALLY(problems().isEmpty());
        QVERIFY2(isClean(), text().constData());
        drive(hand);
    }

private:
    void saveAs(const WindowHand& hand, const QString& path) {
        hand.answerFileDialog(path);
        hand.key(Qt::Key_S, Qt::ControlModifier);
        QVERIFY(QFile::exists(path));
        activate();
    }
    /// As a window manager does when a dialog has closed; shortcuts work in the active window alone.
    void activate() {
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get(), kTimeoutMs));
    }

    /// In millimetres, y up, with a box around it that collides.
    void importHull(const WindowHand& hand) {
        QVERIFY(hand.clickRow("RobotConfig.MyRobot.chassis"));
        QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("Mesh from File")}));
        auto* file = m_window->findChild<QLineEdit*>(QStringLiteral("meshFile"));
        QVERIFY(file);
        file->setFocus();
        QTest::keyClicks(file, m_elsewhere.filePath(QStringLiteral("hull.obj")));
        for (const auto& [name, choice] : {std::pair("meshUnit", "Mill"), {"meshUp", "y"}, {"meshShape", "Convex"}}) {
            auto* box = m_window->findChild<QComboBox*>(QLatin1String(name));
            box->setFocus();
            QTest::keyClicks(box, QLatin1String(choice));
        }
        auto* mass = m_window->findChild<QWidget*>(QStringLiteral("meshMass"))->findChild<QLineEdit*>();
        mass->setFocus();
        mass->selectAll();
        QTest::keyClicks(mass, QStringLiteral("1.5 kg"));
        QVERIFY(hand.press("meshInsert"));
        activate();
    }

    /// Into the row of a property of what is selected.
    void type(const char* property, const QString& value, const char* name = "field") {
        auto* row = m_window->findChild<QWidget*>(QStringLiteral("row.") + QLatin1String(property));
        QVERIFY2(row, property);
        auto* field = row->findChild<QLineEdit*>(QLatin1String(name));
        QVERIFY2(field, name);
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, value);
        QTest::keyClick(field, Qt::Key_Return);
    }

    /// What the Problems panel lists.
    QStringList problems() const {
        const auto* view = m_window->findChild<QTreeView*>(QStringLiteral("problems"));
        QStringList all;
        for (int i = 0; i < view->model()->rowCount(); ++i) all << view->model()->index(i, 0).data().toString();
        return all;
    }

    /// On a plain floor by the keys: half a metre straight ahead.
    void drive(const WindowHand& hand) {
        QVERIFY(hand.clickRow("robot0"));
        hand.key(Qt::Key_E, Qt::ControlModifier);
        QVERIFY(hand.press("modelDrive"));
        RunSession& session = m_window->session();
        EVENTUALLY(session.state() == RunState::Running);
        const auto place = [&] { return session.robots().pose("RobotConfig.MyRobot").value_or(Pose()).position; };
        hand.keyDown(Qt::Key_W);
        EVENTUALLY(place().x() > 0.5);
        hand.keyUp(Qt::Key_W);
        QVERIFY2(std::abs(place().y()) < 0.005, QByteArray::number(place().y()));
        QVERIFY(hand.press("modelDrive"));
    }

    QByteArray text() const {
        return QByteArray::fromStdString(*m_window->document().texts().text(m_window->document().texts().files().front()));
    }
    /// Without errors, and as the formatter would write it.
    bool isClean() const {
        return !m_window->document().loaded()->diagnostics.hasErrors() &&
               format(*m_window->document().loaded()->trees[0]) == text().toStdString();
    }

    WindowFixture m_fixture;
    QTemporaryDir m_folder, m_elsewhere;
    std::unique_ptr<MainWindow> m_window;
};

QTEST_MAIN(MeshRobotTest)
#include "mesh_robot_test.moc"
