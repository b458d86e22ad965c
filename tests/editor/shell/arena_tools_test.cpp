// Arenas by mouse and keys alone, from an empty file: walls and lines drawn corner by corner, rooms, mazes, obstacles, height maps.

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QtTest>

#include "editor/document/document.h"
#include "editor/shell/window_fixture.h"
#include "editor/shell/window_hand.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/view/viewport_panel.h"
#include "eventually.h"
#include "lang/formatter.h"

using namespace trundle;

namespace {

const QByteArray kWalls = R"(#import objects/wall.sim
Static wall1 { Config=Wall Pos=0.025,0,0 length=2.05 }
Static wall2 { Config=Wall Pos=1,0.75,0 HPR=90,0,0 length=1.6 }
Static wall3 { Config=Wall Pos=0.375,1.5,0 length=1.35 }
)";

} // namespace

class ArenaToolsTest : public QObject {
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

    void drawsWallsWithTypedLengths() {
        const WindowHand hand(*m_window);
        newFile(hand);
        QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("Draw Walls")}));
        hand.look({0, -3, 5}, {0, 0.5, 0});
        hand.clickPoint({-1.01, 0.012, 0}); // snaps to the grid
        move({0.4, 0.02, 0});               // along x
        type(QStringLiteral("2"));
        savePicture("draw_walls_typed");
        hand.key(Qt::Key_Return);
        move({1.05, 0.8, 0}); // a right angle
        savePicture("draw_walls_right_angle");
        type(QStringLiteral("150cm"));
        hand.key(Qt::Key_Return);
        hand.clickPoint({-0.32, 1.52, 0});
        hand.key(Qt::Key_Return);
        QCOMPARE(text(), kWalls);
        QVERIFY(isClean());
        QCOMPARE(m_window->selection().paths().size(), std::size_t(3));
        savePicture("draw_walls_done");
        hand.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(text(), QByteArray());
        hand.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(text(), kWalls);
    }

    void backspaceTakesTheCornerBackAndEscapeLeaves() {
        const WindowHand hand(*m_window);
        newFile(hand);
        QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("Draw Walls")}));
        hand.look({0, -3, 5}, {0, 0.5, 0});
        hand.clickPoint({0, 0, 0});
        hand.clickPoint({1, 0, 0});
        hand.clickPoint({1, 1, 0});
        hand.key(Qt::Key_Backspace); // the corner
        move({1, -0.5, 0});
        type(QStringLiteral("3.5"));
        hand.key(Qt::Key_Backspace); // the 5
        hand.key(Qt::Key_Backspace);
        hand.key(Qt::Key_Return); // 3 m down
        hand.key(Qt::Key_Escape); // nothing is written
        QCOMPARE(text(), QByteArray());
        hand.clickPoint({0, 0, 0});
        hand.clickPoint({1, 0, 0});
        hand.key(Qt::Key_Return);
        QCOMPARE(text(), QByteArray("#import objects/wall.sim\nStatic wall1 { Config=Wall Pos=0.5,0,0 length=1 }\n"));
        hand.key(Qt::Key_Escape);
        QVERIFY(m_window->actions().at("tool.select").isChecked());
    }

    void typedAngleAndDoubleClick() {
        const WindowHand hand(*m_window);
        newFile(hand);
        QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("Draw Walls")}));
        hand.look({0, -3, 5}, {0, 0.5, 0});
        hand.clickPoint({0, 0, 0});
        move({1, 0, 0});
        type(QStringLiteral("2"));
        hand.key(Qt::Key_Tab);
        type(QStringLiteral("30"));
        savePicture("draw_walls_angle");
        hand.key(Qt::Key_Return);
        View& view = m_window->viewport().views().current();
        const QPoint at = view.camera().pixelOf({1.7, 2, 0})->toPoint(); // near 90 degrees
        QTest::mouseClick(&view, Qt::LeftButton, {}, at);
        QTest::mouseDClick(&view, Qt::LeftButton, {}, at);
        QVERIFY2(text().contains("HPR=30,0,0"), text().constData());
        QVERIFY2(text().contains("HPR=90,0,0"), text().constData());
        QVERIFY(isClean());
        QCOMPARE(m_window->document().edits().history().entries().size(), std::size_t(1));
    }

    void snapsToEndsUnlessCtrlIsHeld() {
        const WindowHand hand(*m_window);
        newFile(hand);
        QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("Draw Walls")}));
        hand.look({0, -3, 5}, {0, 0.5, 0});
        hand.clickPoint({0, 0, 0});
        hand.clickPoint({1, 0, 0});
        hand.key(Qt::Key_Return);
        hand.clickPoint({1.5, 1.2, 0});
        move({1.02, 0.02, 0});
        savePicture("draw_walls_end");
        hand.clickPoint({1.02, 0.02, 0}); // the end of the first wall
        hand.key(Qt::Key_Return);
        const auto walls = [&] { return m_window->document().loaded()->experiment->statics; };
        QCOMPARE(walls().size(), std::size_t(2));
        QVERIFY2(walls()[1].pose.position.isApprox(Vec3(1.25, 0.6, 0), 1e-3), text().constData());
        View& view = m_window->viewport().views().current();
        for (const Vec3& point : {Vec3(-1.013, 0.987, 0), Vec3(-1.513, 0.537, 0)})
            QTest::mouseClick(&view, Qt::LeftButton, Qt::ControlModifier, view.camera().pixelOf(point)->toPoint());
        hand.key(Qt::Key_Return);
        QCOMPARE(walls().size(), std::size_t(3));
        const Vec3 middle = walls()[2].pose.position;
        QVERIFY2((middle - Vec3(-1.263, 0.762, 0)).norm() < 0.01, text().constData());
        QVERIFY2(std::abs(std::remainder(middle.x(), 0.025)) > 1e-4 || std::abs(std::remainder(middle.y(), 0.025)) > 1e-4,
                 text().constData()); // not on the grid
    }

    /// In the model editor, and in an arena that is open alone, the boxes become parts of it.
    void drawsIntoAnArena() {
        const QByteArray arena =
            "#import common/materials.sim\n#import common/surfaces.sim\n\nStaticConfig Yard {\n  Plane floor { "
            "Material=concrete Surface=ground }\n}\n";
        for (const bool isStage : {false, true}) {
            open(isStage ? arena + "Static yard { Config=Yard }\n" : arena);
            const WindowHand hand(*m_window);
            if (isStage) {
                QVERIFY(hand.clickRow("yard"));
                hand.key(Qt::Key_E, Qt::ControlModifier);
            }
            QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("Draw Walls")}));
            hand.look({0, -3, 5}, {0, 0.5, 0});
            hand.clickPoint({0, 0, 0});
            hand.clickPoint({0, 1, 0});
            hand.key(Qt::Key_Return);
            QVERIFY2(text().contains("  Box wall1 { Pos=0,0.5,0.25 Size=0.1,1,0.5 Material=white Surface=wall }\n}"),
                     text().constData());
            QVERIFY(isClean());
            hand.key(Qt::Key_Z, Qt::ControlModifier);
            QVERIFY(!text().contains("Box"));
        }
    }

    void robotsHaveNoFloorToDrawOn() {
        const WindowHand hand(*m_window);
        newFile(hand);
        QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("New Robot Model")}));
        const QByteArray before = text();
        QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("Draw Walls")}));
        const QSignalSpy refused(&m_window->document(), &Document::refused);
        hand.clickPoint({0.5, 0.5, 0});
        QCOMPARE(refused.count(), 1);
        QCOMPARE(text(), before);
    }

    void drawsALine() {
        const WindowHand hand(*m_window);
        newFile(hand);
        QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("Draw Line on the Floor")}));
        hand.look({0, -2, 3}, {0, 0.3, 0});
        hand.clickPoint({-0.5, 0, 0});
        move({0.2, 0, 0});
        type(QStringLiteral("1"));
        savePicture("draw_line");
        hand.key(Qt::Key_Return);
        hand.key(Qt::Key_Return);
        QCOMPARE(text(), QByteArray("#import objects/floor_line.sim\nStatic line1 { Config=FloorLine }\n"));
        QVERIFY(isClean());
        savePicture("draw_line_done");
    }

    /// From corner to corner of its inside, in one stroke.
    void dragsARoom() {
        const WindowHand hand(*m_window);
        newFile(hand);
        QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("Draw Room")}));
        hand.look({0, -4, 6}, {0, 0.5, 0});
        hand.dragPoints({-1.005, -0.495, 0}, {2.005, 1.505, 0}); // snaps to the grid
        QVERIFY2(text().startsWith("#import common/materials.sim\n#import common/surfaces.sim\n"
                                   "StaticConfig Room {\n  Param height = 0.5   // m, of the walls\n"),
                 text().constData());
        QVERIFY2(text().contains("Box north { Pos=0,1.05,$(height/2) Size=3.2,0.1,$height Material=wood Surface=wall }"),
                 text().constData());
        QVERIFY2(text().contains("Box east { Pos=1.55,0,$(height/2) Size=0.1,2,$height"), text().constData());
        QVERIFY2(text().endsWith("Static room { Config=Room Pos=0.5,0.5,0 }\n"), text().constData());
        QVERIFY(isClean());
        QCOMPARE(m_window->selection().current(), std::string("room"));
        QCOMPARE(m_window->document().edits().history().entries().size(), std::size_t(1));
        savePicture("draw_room_done");
        hand.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(text(), QByteArray());
    }

    /// Its first corner clicked, its sides typed.
    void aRoomWithTypedSides() {
        const WindowHand hand(*m_window);
        newFile(hand);
        QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("Draw Room")}));
        hand.look({0, -4, 6}, {0, 0.5, 0});
        hand.clickPoint({0, 0, 0});
        move({-1, 0.4, 0}); // to the left and up
        type(QStringLiteral("2.5"));
        hand.key(Qt::Key_Tab);
        type(QStringLiteral("150 cm"));
        savePicture("draw_room_typed");
        hand.key(Qt::Key_Return);
        QVERIFY2(text().contains("Static room { Config=Room Pos=-1.25,0.75,0 }"), text().constData());
        QVERIFY2(text().contains("Box north { Pos=0,0.8,$(height/2) Size=2.7,0.1,$height"), text().constData());
        QVERIFY(isClean());
        hand.clickPoint({0.5, 0, 0});
        move({0.6, 0.4, 0});
        const QSignalSpy refused(&m_window->document(), &Document::refused);
        const QByteArray before = text();
        hand.key(Qt::Key_Return); // too small
        QCOMPARE(refused.count(), 1);
        hand.key(Qt::Key_Escape); // the corner
        QCOMPARE(text(), before);
        hand.key(Qt::Key_Escape);
        QVERIFY(m_window->actions().at("tool.select").isChecked());
    }

    /// In the model editor the walls become parts of the arena, at their place.
    void dragsARoomIntoAnArena() {
        open("#import common/materials.sim\n#import common/surfaces.sim\n\nStaticConfig Yard {\n  Plane floor { "
             "Material=concrete Surface=ground }\n}\n");
        const WindowHand hand(*m_window);
        QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("Draw Room")}));
        hand.look({0, -4, 6}, {0, 0.5, 0});
        hand.dragPoints({1, 0, 0}, {2, 1, 0});
        QVERIFY2(text().contains("  Box west { Pos=0.95,0.5,0.25 Size=0.1,1,0.5 Material=wood Surface=wall }\n}"),
                 text().constData());
        QVERIFY(isClean());
        QCOMPARE(m_window->document().edits().history().entries().size(), std::size_t(1));
    }

    /// Obstacles stay clear of the room and of each other; the same seed is the same field.
    void obstaclesInARoom() {
        const WindowHand hand(*m_window);
        newFile(hand);
        QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("Draw Room")}));
        hand.look({0, -5, 7}, {0, 0.5, 0});
        hand.dragPoints({-2, -1.5, 0}, {2, 1.5, 0});
        const QByteArray room = text();
        const auto insert = [&](const QString& seed) {
            QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("Obstacle Field")}));
            auto* count = m_window->findChild<QSpinBox*>(QStringLiteral("fieldCount"));
            QVERIFY(count);
            QCOMPARE(count->findChild<QLineEdit*>()->selectedText(), count->text()); // a number that is typed replaces it
            WindowHand::typeOver(count, QStringLiteral("9"));
            setAmount("fieldWidth", QStringLiteral("3"));
            setAmount("fieldLength", QStringLiteral("400 cm"));
            WindowHand::typeOver(m_window->findChild<QSpinBox*>(QStringLiteral("fieldSeed")), seed);
            QVERIFY(!m_window->findChild<QCheckBox*>(QStringLiteral("fieldFloor"))->isChecked()); // the room has one
            savePicture("obstacles_dialog", m_window->findChild<QDialog*>(QStringLiteral("obstaclesDialog")));
            QVERIFY(hand.press("fieldInsert"));
        };
        insert(QStringLiteral("7"));
        const QByteArray field = text();
        QVERIFY2(field.startsWith(room.left(60)) && field.endsWith("Static obstacles { Config=Obstacles }\n"), field.constData());
        QVERIFY(isClean());
        const auto& statics = m_window->document().loaded()->experiment->statics;
        QCOMPARE(statics.at(1).geoms->size(), std::size_t(9));
        for (const GeomSpec& obstacle : *statics[1].geoms) {
            const Vec3& at = obstacle.pose.position;
            QVERIFY(std::abs(at.x()) < 2 && std::abs(at.y()) < 1.5 && at.head<2>().norm() > 0.5);
        }
        savePicture("obstacles_done");
        hand.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(text(), room);
        insert(QStringLiteral("7"));
        QCOMPARE(text(), field);
        hand.key(Qt::Key_Z, Qt::ControlModifier);
        insert(QStringLiteral("8"));
        QVERIFY(text() != field);
    }

    void tooManyObstaclesAreRefused() {
        const WindowHand hand(*m_window);
        newFile(hand);
        QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("Obstacle Field")}));
        WindowHand::typeOver(m_window->findChild<QSpinBox*>(QStringLiteral("fieldCount")), QStringLiteral("1999"));
        QVERIFY(!hand.press("fieldInsert"));
        const QString why = m_window->findChild<QLabel*>(QStringLiteral("fieldResult"))->text();
        QVERIFY2(why.startsWith(QStringLiteral("There is no room for 1999 obstacles")), qPrintable(why));
        setAmount("fieldLeast", QStringLiteral("2"));
        QVERIFY(!hand.press("fieldInsert"));
    }

    void roomWithADoor() {
        const WindowHand hand(*m_window);
        newFile(hand);
        QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("Room")}));
        QVERIFY(m_window->findChild<QWidget*>(QStringLiteral("roomLength"))->findChild<QLineEdit*>()->hasSelectedText());
        setAmount("roomLength", QStringLiteral("5"));
        setAmount("roomWidth", QStringLiteral("400 cm"));
        auto* side = m_window->findChild<QComboBox*>(QStringLiteral("roomDoor"));
        QVERIFY(side);
        side->setFocus();
        QTest::keyClicks(side, QStringLiteral("South"));
        savePicture("room_dialog", m_window->findChild<QDialog*>(QStringLiteral("roomDialog")));
        QVERIFY(hand.press("roomInsert"));
        const QByteArray room = text();
        QVERIFY2(room.contains("StaticConfig Room {") && room.endsWith("Static room { Config=Room }\n"), room.constData());
        QVERIFY2(room.contains("Box south1 { Pos=-1.5,-2.05,$(height/2) Size=2.2,0.1,$height"), room.constData());
        QVERIFY2(room.contains("Plane floor"), room.constData());
        QVERIFY(isClean());
        QCOMPARE(m_window->selection().current(), std::string("room"));
        savePicture("room_done");
        hand.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(text(), QByteArray());
        hand.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(text(), room);
        QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("Room")}));
        QVERIFY(!m_window->findChild<QCheckBox*>(QStringLiteral("roomFloor"))->isChecked()); // there is one
        setAmount("roomLength", QStringLiteral("-1"));
        QVERIFY(!hand.press("roomInsert"));
        setAmount("roomLength", QStringLiteral("1"));
        QVERIFY(hand.press("roomInsert"));
        QVERIFY2(text().contains("Config=Room2 }"), text().constData());
    }

    void maze() {
        const WindowHand hand(*m_window);
        newFile(hand);
        QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("Maze")}));
        auto* rows = m_window->findChild<QSpinBox*>(QStringLiteral("mazeRows"));
        QVERIFY(rows);
        QTest::keyClicks(rows, QStringLiteral("4"));
        QCOMPARE(rows->value(), 4);
        savePicture("maze_dialog", m_window->findChild<QDialog*>(QStringLiteral("mazeDialog")));
        QVERIFY(hand.press("mazeInsert"));
        QVERIFY2(text().contains("Static maze { Config=Maze }"), text().constData());
        QVERIFY(isClean());
        const auto& walls = *m_window->document().loaded()->experiment->statics[0].geoms;
        QVERIFY(walls.size() > 10);
        savePicture("maze_done");
        hand.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(text(), QByteArray());
    }

    void heightMap() {
        QTemporaryDir elsewhere;
        QImage hills(40, 30, QImage::Format_Grayscale16);
        for (int y = 0; y < hills.height(); ++y)
            for (int x = 0; x < hills.width(); ++x) reinterpret_cast<quint16*>(hills.scanLine(y))[x] = quint16(x * 300 + y * 900);
        const QString picture = elsewhere.filePath(QStringLiteral("hills.png"));
        QVERIFY(hills.save(picture));
        open("Tick = 0.01\n");
        const WindowHand hand(*m_window);
        QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("Height Map")}));
        QVERIFY(!hand.press("heightsInsert"));
        auto* file = m_window->findChild<QLineEdit*>(QStringLiteral("heightsPicture"));
        QVERIFY(file);
        file->setFocus();
        QTest::keyClicks(file, picture);
        setAmount("heightsHeight", QStringLiteral("2"));
        savePicture("heights_dialog", m_window->findChild<QDialog*>(QStringLiteral("heightsDialog")));
        QVERIFY(hand.press("heightsInsert"));
        QVERIFY2(text().contains("Heightfield ground { File=hills.png Size=10,10,2 Material=concrete Surface=ground }"),
                 text().constData());
        QVERIFY(QFile::exists(m_folder.filePath(QStringLiteral("hills.png"))));
        EVENTUALLY(isClean()); // once the picture is read
        const auto statics = m_window->document().loaded()->experiment->statics;
        QCOMPARE(statics.size(), std::size_t(1));
        savePicture("heights_done");
        hand.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(text(), QByteArray("Tick = 0.01\n"));
    }

private:
    void newFile(const WindowHand& hand) {
        QVERIFY(hand.choose({QStringLiteral("File"), QStringLiteral("New"), QStringLiteral("Empty File")}));
    }
    void open(const QByteArray& text) {
        QFile file(m_folder.filePath(QStringLiteral("yard.sim")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text);
        file.close();
        QVERIFY(m_window->document().opening().open(file.fileName().toStdString()).ok());
    }
    void move(const Vec3& point) {
        View& view = m_window->viewport().views().current();
        QTest::mouseMove(&view, view.camera().pixelOf(point)->toPoint());
    }
    void type(const QString& keys) { QTest::keyClicks(QApplication::focusWidget(), keys); }
    void setAmount(const char* name, const QString& value) {
        auto* field = m_window->findChild<QWidget*>(QLatin1String(name));
        QVERIFY(field);
        auto* line = field->findChild<QLineEdit*>();
        QVERIFY(line);
        line->setFocus();
        line->selectAll();
        QTest::keyClicks(line, value);
    }
    QByteArray text() const {
        return QByteArray::fromStdString(*m_window->document().texts().text(m_window->document().texts().files().front()));
    }
    /// Without errors, and as the formatter would write it.
    bool isClean() const {
        return !m_window->document().loaded()->diagnostics.hasErrors() &&
               format(*m_window->document().loaded()->trees[0]) == text().toStdString();
    }
    void savePicture(const char* name, QWidget* widget = nullptr) { WindowFixture::savePicture(*m_window, name, widget); }

    WindowFixture m_fixture;
    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;
};

QTEST_MAIN(ArenaToolsTest)
#include "arena_tools_test.moc"
