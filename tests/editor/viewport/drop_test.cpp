#include <QtTest>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMimeData>

#include "editor/viewport/library_drop.h"
#include "editor/viewport/view_window.h"

using namespace trundle;

class DropTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_render = RenderService::startInBackground(); }
    void init() {
        m_window = std::make_unique<ViewWindow>(m_render.get());
        QVERIFY(m_window->open(kRoom));
        m_window->look({0, -2.5, 2.5}, {0, 0, 0});
    }
    void cleanup() { m_window.reset(); }

    void aRobotStandsWhereItWasDropped() {
        drop("Robot", "Robot robot { Config=SimpleRobot }", {}, {0.2, -0.7, 0});
        QVERIFY2(m_window->text().contains("Pos=0.2,-0.7,0"), m_window->text().constData());
        QCOMPARE(m_window->document.loaded()->experiment->robots.size(), std::size_t(3));
        QCOMPARE(m_window->selection.paths().size(), std::size_t(1));
        m_window->document.undo();
        QCOMPARE(m_window->text(), kRoom);
    }

    void aRobotOfAnotherFileBringsItsImport() {
        drop("Robot", "Robot amr { Config=Amr Pos=0,0,0 }", {QStringLiteral("robots/amr.sim")}, {0.2, -0.7, 0});
        QVERIFY2(m_window->text().contains("#import robots/amr.sim"), m_window->text().constData());
        QVERIFY(!m_window->document.loaded()->diagnostics.hasErrors());
    }

    void aShapeGoesIntoTheArenaItFallsOn() {
        QVERIFY(m_window->open("StaticConfig Yard {\n  Plane floor { }\n}\nStatic yard { Config=Yard Pos=0,0,0 }\n"));
        m_window->look({0, -2.5, 2.5}, {0, 0, 0});
        drop("Box", "Box crate { Size=0.4,0.4,0.6 }", {}, {0.5, 0.5, 0});
        QVERIFY2(m_window->text().contains("Pos=0.5,0.5,0.3"), m_window->text().constData());
        QCOMPARE(m_window->selection.paths().size(), std::size_t(1));
    }

    void aShapeOnNothingIsRefusedInWords() {
        QVERIFY(m_window->open("Tick = 0.01\n"));
        drop("Box", "Box crate { Size=0.4,0.4,0.6 }", {}, {0.5, 0.5, 0});
        QCOMPARE(m_window->refusals.size(), std::size_t(1));
        QCOMPARE(m_window->text(), QByteArray("Tick = 0.01\n"));
    }

    void aMaterialColoursWhatItFallsOn() {
        QVERIFY(m_window->open("Material blue { ColorRGB=0,0,1 }\nStaticConfig Yard {\n  Box crate { Size=1,1,1 }\n}\nStatic "
                               "yard { Config=Yard Pos=0,0,0 }\n"));
        m_window->look({0, -3, 2.5}, {0, 0, 0});
        drop("Material", "Material blue { ColorRGB=0,0,1 }", {}, {0, 0, 0.5});
        QVERIFY2(m_window->text().contains("crate.Material"), m_window->text().constData());
        QCOMPARE(m_window->document.history().entries().size(), std::size_t(1));
    }

    // ---- rows of the scene tree ----

    void aRowOfTheTreeMovesItsObject() {
        m_window->selection.select("robot0");
        QCOMPARE(dropRows({"robot0"}, {0.2, -0.7, 0}), Qt::MoveAction);
        QVERIFY2(m_window->text().contains("Robot robot0 { Config=SimpleRobot Pos=0.2,-0.7,0 HPR=0,0,0 } // the first"),
                 m_window->text().constData());
        QCOMPARE(m_window->document.loaded()->experiment->robots.size(), std::size_t(2));
        QCOMPARE(m_window->document.history().entries().size(), std::size_t(1));
        m_window->document.undo();
        QCOMPARE(m_window->text(), kRoom);
    }

    void severalRowsKeepTheirPlacesBesideEachOther() {
        m_window->selection.set({"robot1", "robot0"});
        QCOMPARE(dropRows({"robot0", "robot1"}, {0.2, -0.7, 0}), Qt::MoveAction);
        QVERIFY2(m_window->text().contains("Pos=0.2,-0.7,0 "), m_window->text().constData());
        QVERIFY2(m_window->text().contains("Pos=1.2,-0.4,0 "), m_window->text().constData());
    }

    void withCtrlItIsACopy() {
        m_window->selection.select("robot0");
        QCOMPARE(dropRows({"robot0"}, {0.2, -0.7, 0}, Qt::ControlModifier), Qt::CopyAction);
        QVERIFY2(m_window->text().contains("Pos=-0.5,0,0"), m_window->text().constData());
        QVERIFY2(m_window->text().contains("Pos=0.2,-0.7,0"), m_window->text().constData());
        QCOMPARE(m_window->document.loaded()->experiment->robots.size(), std::size_t(3));
        QCOMPARE(m_window->document.history().entries().size(), std::size_t(1));
    }

    void whatCannotBeMovedIsSaid() {
        QVERIFY(m_window->open(QByteArray(kRoom).replace("Robot robot1 {", "Grid robot1 { Count=2,1 Spacing=1,1")));
        const QByteArray before = m_window->text();
        m_window->selection.select("robot1_0");
        QCOMPARE(dropRows({"robot1_0"}, {0.2, -0.7, 0}), Qt::MoveAction);
        QCOMPARE(m_window->text(), before);
        QCOMPARE(m_window->refusals.size(), std::size_t(1));
    }

    void rowsOfAnotherProgramAreCopies() {
        m_window->selection.select("robot0");
        QCOMPARE(dropRows({"robot0"}, {0.2, -0.7, 0}, {}, "1 "), Qt::CopyAction);
        QCOMPARE(m_window->document.loaded()->experiment->robots.size(), std::size_t(3));
    }

    void rubbishIsNotTaken_data() {
        QTest::addColumn<QByteArray>("json");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("no JSON") << QByteArray("Robot x {");
        QTest::newRow("no text") << QByteArray("{\"kind\":\"Robot\"}");
        QTest::newRow("unknown kind") << QByteArray("{\"kind\":\"Dragon\",\"text\":\"Dragon d { }\"}");
        QTest::newRow("broken text") << QByteArray("{\"kind\":\"Robot\",\"text\":\"} } Robot {\"}");
        QTest::newRow("a list") << QByteArray("[1,2,3]");
        QTest::newRow("numbers for words") << QByteArray("{\"kind\":3,\"text\":7,\"imports\":9}");
    }
    void rubbishIsNotTaken() {
        QFETCH(const QByteArray, json);
        QMimeData data;
        data.setData(QStringLiteral("application/x-trundle-library"), json);
        dropBlocks(m_window->view(), data, {300, 300});
        QCOMPARE(m_window->text(), kRoom);
    }

private:
    Qt::DropAction dropRows(const QByteArrayList& paths, const Vec3& where, Qt::KeyboardModifiers modifiers = {},
                            const QByteArray& program = QByteArray::number(QCoreApplication::applicationPid()) + ' ') {
        QMimeData data;
        data.setData(QStringLiteral("application/x-trundle-objects"), program + "1f\n" + paths.join('\n') + '\n');
        data.setData(QStringLiteral("application/x-trundle-library"),
                     R"({"kind":"Robot","text":"Robot robot0 { Config=SimpleRobot Pos=0,0,0 }","imports":[]})");
        const QPoint at = m_window->at(where);
        const Qt::DropActions all = Qt::MoveAction | Qt::CopyAction;
        QDragEnterEvent enter(at, all, &data, Qt::LeftButton, modifiers);
        QCoreApplication::sendEvent(&m_window->view(), &enter);
        QDragMoveEvent move(at, all, &data, Qt::LeftButton, modifiers);
        QCoreApplication::sendEvent(&m_window->view(), &move);
        QDropEvent event(at, all, &data, Qt::LeftButton, modifiers);
        QCoreApplication::sendEvent(&m_window->view(), &event);
        return enter.isAccepted() && enter.dropAction() == event.dropAction() && event.isAccepted() ? move.dropAction()
                                                                                                    : Qt::IgnoreAction;
    }

    void drop(const char* kind, const char* text, const QStringList& imports, const Vec3& where) {
        QMimeData data;
        const QJsonObject json{{QStringLiteral("kind"), QLatin1String(kind)},
                               {QStringLiteral("text"), QLatin1String(text)},
                               {QStringLiteral("imports"), QJsonArray::fromStringList(imports)}};
        data.setData(QStringLiteral("application/x-trundle-library"), QJsonDocument(json).toJson());
        const QPoint at = m_window->at(where);
        QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&m_window->view(), &enter);
        QVERIFY(enter.isAccepted());
        QDragMoveEvent move(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&m_window->view(), &move);
        QDropEvent event(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&m_window->view(), &event);
    }

    std::unique_ptr<RenderService> m_render;
    std::unique_ptr<ViewWindow> m_window;
};

QTEST_MAIN(DropTest)
#include "drop_test.moc"
