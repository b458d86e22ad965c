// A mesh from a file by mouse and keys: into an experiment, into a robot; with unit, up axis, shape, textures and undo.

#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

#include "editor/document/document.h"
#include "editor/shell/window_fixture.h"
#include "editor/shell/window_hand.h"
#include "editor/viewport/view/viewport_panel.h"
#include "eventually.h"
#include "lang/formatter.h"

using namespace trundle;

namespace {

/// A box of 300 x 100 x 200, y up, with a material.
QByteArray boxObj() {
    QByteArray text = "mtllib box.mtl\nusemtl paint\n";
    for (int i = 0; i < 8; ++i)
        text += "v " + QByteArray::number(i & 1 ? 300 : 0) + ' ' + QByteArray::number(i & 2 ? 100 : 0) + ' ' +
                QByteArray::number(i & 4 ? 200 : 0) + '\n';
    for (const char* face : {"1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"})
        text += QByteArray("f ") + face + '\n';
    return text;
}

const QByteArray kRover = R"(#import common/materials.sim
#import common/surfaces.sim
RobotConfig Rover {
  Body chassis {
    Box hull { Size=0.3,0.2,0.1 Pos=0,0,0.05 Mass=2 Material=blue Surface=plastic }
  }
}
Robot robot0 { Config=Rover }
)";

} // namespace

class MeshImportTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        m_fixture.start();
        write(m_elsewhere.filePath(QStringLiteral("my box.obj")), boxObj());
        write(m_elsewhere.filePath(QStringLiteral("box.mtl")), "newmtl paint\nKd 0.8 0.2 0.1\n");
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

    void becomesSceneryOfAnExperiment() {
        const QByteArray before = "Tick = 0.01\n#import arenas/open_floor.sim\nStatic floor { Config=OpenFloor }\n";
        open(before);
        const WindowHand hand(*m_window);
        choose(hand);
        savePicture("mesh_dialog", m_window->findChild<QDialog*>(QStringLiteral("meshDialog")));
        QVERIFY(hand.press("meshInsert"));
        const QByteArray mesh =
            "  Mesh myBox { File=\"meshes/my box/my box.obj\" Scale=0.001 Pos=-0.15,0.1,0 HPR=0,0,90 Shape=none "
            "Surface=wall }\n  Box myBoxShape { Pos=0,0,0.05 Size=0.3,0.2,0.1 Visible=false Material=grey Surface=wall }\n";
        QVERIFY2(text().contains("StaticConfig MyBox {\n" + mesh + "}\nStatic myBox { Config=MyBox }\n"), text().constData());
        EVENTUALLY(isClean()); // once the mesh is read
        QVERIFY(QFile::exists(m_folder.filePath(QStringLiteral("meshes/my box/box.mtl"))));
        savePicture("mesh_done");
        hand.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(text(), before);
    }

    void becomesPartOfABody() {
        open(kRover);
        const WindowHand hand(*m_window);
        QVERIFY(hand.clickRow("robot0"));
        hand.key(Qt::Key_E, Qt::ControlModifier);
        choose(hand);
        auto* shape = m_window->findChild<QComboBox*>(QStringLiteral("meshShape"));
        shape->setFocus();
        QTest::keyClicks(shape, QStringLiteral("Convex"));
        auto* mass = m_window->findChild<QWidget*>(QStringLiteral("meshMass"))->findChild<QLineEdit*>();
        mass->setFocus();
        mass->selectAll();
        QTest::keyClicks(mass, QStringLiteral("500 g"));
        QVERIFY(hand.press("meshInsert"));
        QVERIFY2(text().contains("Shape=hull Mass=0.5 Surface=plastic }\n  }\n}\nRobot"), text().constData());
        EVENTUALLY(isClean()); // once the mesh is read
        const RobotSpec& robot = m_window->document().loaded()->experiment->robots.at(0);
        QVERIFY(std::abs(robot.config->bodies[0].mass.mass - 2.5) < 1e-9);
        QCOMPARE(m_window->document().edits().history().entries().size(), std::size_t(1));
        hand.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(text(), kRover);
    }

    /// An L in centimetres, z up: two hulls, nothing between its legs, in one edit.
    void severalHullsKeepItsHollow() {
        open("Tick = 0.01\n");
        QByteArray obj;
        for (const int z : {0, 10})
            for (const auto& [x, y] : {std::pair(0, 0), {30, 0}, {30, 5}, {5, 5}, {5, 20}, {0, 20}})
                obj += "v " + QByteArray::number(x) + ' ' + QByteArray::number(y) + ' ' + QByteArray::number(z) + '\n';
        for (const char* face : {"1 4 3 2", "1 6 5 4", "7 8 9 10", "7 10 11 12", "1 2 8 7", "2 3 9 8", "3 4 10 9", "4 5 11 10",
                                 "5 6 12 11", "6 1 7 12"})
            obj += QByteArray("f ") + face + '\n';
        write(m_elsewhere.filePath(QStringLiteral("angle.obj")), obj);
        const WindowHand hand(*m_window);
        QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("Mesh from File")}));
        WindowHand::typeOver(m_window->findChild<QLineEdit*>(QStringLiteral("meshFile")),
                             m_elsewhere.filePath(QStringLiteral("angle.obj")));
        for (const auto& [name, choice] : {std::pair("meshUnit", "Cent"), {"meshShape", "Several"}}) {
            auto* box = m_window->findChild<QComboBox*>(QLatin1String(name));
            box->setFocus();
            QTest::keyClicks(box, QLatin1String(choice));
        }
        const QString said = m_window->findChild<QLabel*>(QStringLiteral("meshResult"))->text();
        QVERIFY2(said.contains(QStringLiteral("at most 0 mm away from those of 2 hulls that collide")), qPrintable(said));
        savePicture("mesh_hulls", m_window->findChild<QDialog*>(QStringLiteral("meshDialog")));
        QVERIFY(hand.press("meshInsert"));
        QVERIFY2(text().contains("  Convex anglePart1 { File=meshes/angle/angle_part1.obj Visible=false Material=grey "
                                 "Surface=wall }\n  Convex anglePart2 {"),
                 text().constData());
        EVENTUALLY(isClean()); // once the meshes are read
        QCOMPARE(m_window->document().loaded()->experiment->statics.at(0).geoms->size(), std::size_t(3));
        savePicture("mesh_hulls_done");
        hand.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(text(), QByteArray("Tick = 0.01\n"));
    }

    void whatCannotBeReadIsSaid() {
        open("Tick = 0.01\n");
        write(m_elsewhere.filePath(QStringLiteral("bad.stl")), "solid nothing");
        const WindowHand hand(*m_window);
        QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("Mesh from File")}));
        for (const char* name : {"bad.stl", "none.stl"}) {
            auto* file = m_window->findChild<QLineEdit*>(QStringLiteral("meshFile"));
            file->setText(m_elsewhere.filePath(QLatin1String(name)));
            QVERIFY(!hand.press("meshInsert"));
            QVERIFY(!m_window->findChild<QLabel*>(QStringLiteral("meshResult"))->text().isEmpty());
        }
    }

private:
    static void write(const QString& path, const QByteArray& bytes) {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(bytes), bytes.size());
    }
    /// The mesh, in millimetres, y up; the shape stays the proposed one.
    void choose(const WindowHand& hand) {
        QVERIFY(hand.choose({QStringLiteral("Insert"), QStringLiteral("Mesh from File")}));
        auto* file = m_window->findChild<QLineEdit*>(QStringLiteral("meshFile"));
        QVERIFY(file);
        QCOMPARE(file->window()->focusWidget(), static_cast<QWidget*>(file));
        QVERIFY(file->width() > file->fontMetrics().horizontalAdvance(file->placeholderText()));
        QTest::keyClicks(file, m_elsewhere.filePath(QStringLiteral("my box.obj")));
        for (const auto& [name, choice] : {std::pair("meshUnit", "Mill"), {"meshUp", "y"}}) {
            auto* box = m_window->findChild<QComboBox*>(QLatin1String(name));
            box->setFocus();
            QTest::keyClicks(box, QLatin1String(choice));
        }
    }
    void open(const QByteArray& text) {
        write(m_folder.filePath(QStringLiteral("room.sim")), text);
        QVERIFY(m_window->document().opening().open(m_folder.filePath(QStringLiteral("room.sim")).toStdString()).ok());
    }
    QByteArray text() const {
        return QByteArray::fromStdString(*m_window->document().texts().text(m_window->document().texts().files().front()));
    }
    /// Without problems, and as the formatter would write it.
    bool isClean() const {
        return !m_window->document().loaded()->diagnostics.hasErrors() &&
               format(*m_window->document().loaded()->trees[0]) == text().toStdString();
    }
    void savePicture(const char* name, QWidget* widget = nullptr) { WindowFixture::savePicture(*m_window, name, widget); }

    WindowFixture m_fixture;
    QTemporaryDir m_folder, m_elsewhere;
    std::unique_ptr<MainWindow> m_window;
};

QTEST_MAIN(MeshImportTest)
#include "mesh_import_test.moc"
