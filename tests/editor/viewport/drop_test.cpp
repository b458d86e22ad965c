// Dropping objects from the Library and the Scene tree into a 3D view.
#include <QtTest>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMimeData>

#include "editor/viewport/tools/library_drop.h"
#include "editor/viewport/view_window.h"
#include "eventually.h"

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

    void placesRobotAtDropPoint() {
        drop("Robot", "Robot robot { Config=SimpleRobot }", {}, {0.2, -0.7, 0});
        QVERIFY2(m_window->text().contains("Pos=0.2,-0.7,0"), m_window->text().constData());
        QCOMPARE(m_window->document.loaded()->experiment->robots.size(), std::size_t(3));
        QCOMPARE(m_window->selection.paths().size(), std::size_t(1));
        m_window->document.edits().undo();
        QCOMPARE(m_window->text(), kRoom);
    }

    void insertsImportWithRobot() {
        drop("Robot", "Robot amr { Config=Amr Pos=0,0,0 }", {QStringLiteral("robots/amr.sim")}, {0.2, -0.7, 0});
        QVERIFY2(m_window->text().contains("#import robots/amr.sim"), m_window->text().constData());
        QVERIFY(!m_window->document.loaded()->diagnostics.hasErrors());
    }

    void addsShapeToArenaBelow() {
        QVERIFY(m_window->open("StaticConfig Yard {\n  Plane floor { }\n}\nStatic yard { Config=Yard Pos=0,0,0 }\n"));
        m_window->look({0, -2.5, 2.5}, {0, 0, 0});
        drop("Box", "Box crate { Size=0.4,0.4,0.6 }", {}, {0.5, 0.5, 0});
        QVERIFY2(m_window->text().contains("Pos=0.5,0.5,0.3"), m_window->text().constData());
        QCOMPARE(m_window->selection.paths().size(), std::size_t(1));
    }

    void rejectsShapeDroppedOnNothing() {
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
        QVERIFY2(m_window->text().contains("Box crate { Size=1,1,1 Material=blue }"),
                 m_window->text().constData()); // its only instance
        QCOMPARE(m_window->document.edits().history().entries().size(), std::size_t(1));
    }

    void dropOnSideFacePlacesBeside() {
        QVERIFY(m_window->open("#import arenas/open_floor.sim\n#import objects/wall.sim\nStatic ground { Config=OpenFloor }\n"
                               "Static wall { Config=Wall Pos=0,0,0 HPR=30,0,0 }\n"));
        m_window->look({1.2, -2.5, 1.5}, {0, 0, 0.2});
        const Vec3 normal = rotationFromHpr({M_PI / 6, 0, 0}) * Vec3(0, -1, 0), face = 0.05 * normal + Vec3(0, 0, 0.3);
        drop("Robot", "Robot crate { Config=Crate Pos=0,0,0 }", {QStringLiteral("objects/crate.sim")}, face);
        const ExperimentSpec& experiment = *m_window->document.loaded()->experiment;
        QCOMPARE(experiment.robots.size(), std::size_t(1));
        const Vec3 at = experiment.robots[0].pose.position;
        QCOMPARE(at.z(), 0.0);
        const double reach = 0.125 * (std::abs(normal.x()) + std::abs(normal.y())); // from centre to corner
        const double gap = normal.dot(at) - 0.05 - reach; // of less than one millimetre, in which Pos is rounded
        QVERIFY2(gap > -1e-5 && gap < 1.5e-3, m_window->text().constData());
        // On the wall, it rests on the top.
        drop("Robot", "Robot crate { Config=Crate Pos=0,0,0 }", {QStringLiteral("objects/crate.sim")}, {0, 0, 0.5});
        QVERIFY(std::abs(m_window->document.loaded()->experiment->robots.at(1).pose.position.z() - 0.5) < 1e-5);
    }

    void previewsDropPose() {
        QVERIFY(m_window->open("#import arenas/open_floor.sim\nStatic ground { Config=OpenFloor }\n"));
        m_window->look({0, -2.5, 2.5}, {0, 0, 0});
        m_window->trigger("view.overlayShadows");
        EVENTUALLY(m_window->panel->isSettled());
        View& view = m_window->view();
        const QImage before = view.image().picture();
        const Vec3 places[] = {{0.5, 0.2, 0}, {-0.5, -0.3, 0}};
        QMimeData data;
        fill(data, "Robot", "Robot ball { Config=RollingBall Pos=1,1,1 }", {QStringLiteral("objects/rolling_ball.sim")});
        const auto isSeen = [&](const Vec3& where) {
            const QPoint at = m_window->at(where + Vec3(0, 0, 0.08));
            return qRed(view.image().picture().pixel(at)) > qRed(before.pixel(at)) + 40; // an orange ball on a grey floor
        };
        const auto drag = [&](QDragMoveEvent&& event) { QCoreApplication::sendEvent(&view, &event); };
        drag(QDragEnterEvent(m_window->at(places[0]), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier));
        EVENTUALLY(m_window->panel->views().isUpToDate() && isSeen(places[0]) && !isSeen(places[1]));
        const SceneId scene = m_window->panel->world().dragged().scene();
        drag(QDragMoveEvent(m_window->at(places[1]), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier));
        EVENTUALLY(m_window->panel->views().isUpToDate() && isSeen(places[1]) && !isSeen(places[0]));
        QVERIFY(scene == m_window->panel->world().dragged().scene()); // the scene was not rebuilt
        QVERIFY(m_window->document.loaded()->experiment->robots.empty() &&
                m_window->document.edits().history().entries().empty());
        QDragLeaveEvent leave;
        QCoreApplication::sendEvent(&view, &leave);
        EVENTUALLY(m_window->panel->isSettled());
        QVERIFY(view.image().picture() == before);
        // The drop places it where the preview was.
        drag(QDragEnterEvent(m_window->at(places[1]), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier));
        const Pose shown = m_window->panel->world().dragged().pose().value();
        QDropEvent event(m_window->at(places[1]), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&view, &event);
        QVERIFY((m_window->document.loaded()->experiment->robots.at(0).pose.position - shown.position).norm() < 1e-9);
        QVERIFY(!m_window->panel->world().dragged().pose());
    }

    void aShapeOnARobotTouchesTheFaceItFallsOn() {
        m_window->look({-0.5, -2.5, 1.0}, {-0.5, 0, 0.1});
        drop("Sphere", "Sphere nose { Radius=0.03 }", {}, {-0.5, -0.1, 0.1}); // on the right side of robot0's hull
        const BodySpec& chassis = m_window->document.loaded()->experiment->robots.at(0).config->bodies.at(0);
        const auto nose = std::ranges::find(chassis.geoms, std::string("nose"), &GeomSpec::name);
        QVERIFY2(nose != chassis.geoms.end(), m_window->text().constData());
        QVERIFY2(std::abs(nose->pose.position.y() + 0.13) < 1e-4, qPrintable(QString::number(nose->pose.position.y())));
    }

    /// The Library writes a shape for the selection; it gets the values that fit what it is dropped on.
    void aShapeOfTheLibraryFitsWhatItFallsOn_data() {
        QTest::addColumn<QByteArray>("written");
        QTest::newRow("nothing selected") << QByteArray("Box box { Size=0.1,0.1,0.1 Material=red Surface=stone }");
        QTest::newRow("a body selected") << QByteArray("Box box { Size=0.1,0.1,0.1 Pos=0,0,0.5 Material=blue Mass=0.1 }");
    }
    void aShapeOfTheLibraryFitsWhatItFallsOn() {
        QFETCH(const QByteArray, written);
        QVERIFY(
            m_window->open("Material red { ColorRGB=1,0,0 }\nMaterial blue { ColorRGB=0,0,1 }\nStaticConfig Yard {\n  Box wall { "
                           "Pos=1,0,0.2 Size=0.4,0.4,0.4 Material=blue }\n}\nStatic yard { Config=Yard Pos=0,0,0 }\n"
                           "RobotConfig Kit {\n  Body b { Box hull { Size=0.3,0.2,0.1 Pos=0,0,0.05 Mass=1 Material=blue } }\n}\n"
                           "Robot kit { Config=Kit Pos=0,0,0 }\n"));
        m_window->look({0.5, -2, 2}, {0.5, 0, 0.1});
        drop("Box", written, {}, {0, 0, 0.1}, true);
        QVERIFY2(m_window->text().contains("Box box { Size=0.1,0.1,0.1 Pos=0,0,0.15 Material=blue Mass=0.1 }"),
                 m_window->text().constData());
        drop("Box", written, {}, {1, 0, 0.4}, true);
        QVERIFY2(m_window->text().contains("Box box { Size=0.1,0.1,0.1 Pos=1,0,0.45 Material=blue }"),
                 m_window->text().constData());
    }

    /// As far as it is seen to be: from afar within centimetres, from near not even within three.
    void aWheelFindsTheMirrorImageAsFarAsItIsSeen_data() {
        QTest::addColumn<double>("distance");
        QTest::addColumn<double>("beside");
        QTest::addColumn<bool>("isFound");
        QTest::newRow("afar") << 3.0 << 0.05 << true;
        QTest::newRow("near") << 0.4 << 0.022 << false;
        QTest::newRow("near, there") << 0.4 << 0.005 << true;
    }
    void aWheelFindsTheMirrorImageAsFarAsItIsSeen() {
        QFETCH(double, distance);
        QFETCH(double, beside);
        QFETCH(bool, isFound);
        QVERIFY(m_window->open(
            "RobotConfig Kit {\n  Body chassis { Box hull { Size=0.4,0.2,0.08 Pos=0,0,0.08 Mass=1 } }\n"
            "  Body leftWheel { Pos=0.0623,0.122,0.05 Cylinder tyre { Radius=0.05 Length=0.03 HPR=0,0,90 Mass=0.1 } }\n"
            "  Hinge leftAxle { Parent=chassis Child=leftWheel Axis=0,1,0 }\n}\nRobot kit { Config=Kit }\n"));
        m_window->look({0.06, -distance, 0.5 * distance}, {0.06, 0, 0.08});
        drop("Body",
             "Body wheel { Pos=0,0.125,0.05\n  Cylinder tyre { Radius=0.05 Length=0.03 HPR=0,0,90 Mass=0.15 } }\nHinge axle { "
             "Parent=chassis Child=wheel Axis=0,1,0 }\n",
             {}, {0.0623 - beside, -0.1, 0.08});
        QVERIFY2(m_window->text().contains("Body rightWheel { Pos="), m_window->text().constData());
        QVERIFY2(m_window->text().contains("Pos=0.0623,-0.122,0.05") == isFound, m_window->text().constData());
    }

    void aTurnedPartHasItsPlaceOnOneLine() {
        QVERIFY(m_window->open("RobotConfig Kit {\n  Body chassis { Box hull { Size=0.4,0.2,0.08 Pos=0,0,0.08 Mass=1 } }\n}\n"
                               "Robot kit { Config=Kit }\n"));
        m_window->look({0, -1, 0.4}, {0, 0, 0.08});
        drop("Body",
             "Body bumper { Pos=0.16,0,0.07\n  Box bar { Size=0.02,0.30,0.04 Mass=0.05 } }\nFixed bumperHold { Parent=chassis "
             "Child=bumper }\n",
             {}, {0, -0.1, 0.08});
        QVERIFY2(m_window->text().contains(" HPR=-90,0,0\n"), m_window->text().constData());
        QVERIFY2(m_window->text().contains("Body bumper { Pos=0,-0.11"), m_window->text().constData());
    }

    // ---- rows of the Scene tree ----

    /// To the middle of the face, to its edges; without snapping nowhere.
    void onAFaceThingsSnap() {
        const QByteArray crate =
            "RobotConfig Crate {\n  Body b { Box hull { Size=0.3,0.2,0.1 Pos=0,0,0.05 Mass=1 } }\n}\nRobot crate { "
            "Config=Crate }\n";
        const auto begin = [&] {
            QVERIFY(m_window->open(crate));
            m_window->look({0, -0.3, 0.9}, {0, 0, 0.1});
        };
        begin();
        drop("Camera", "Camera eye { Body=b }", {}, {0.006, -0.005, 0.1});
        QVERIFY2(m_window->text().contains("Camera eye { Body=b Pos=0,0,0.1 }"), m_window->text().constData());
        begin();
        drop("Camera", "Camera eye { Body=b }", {}, {0.147, 0.053, 0.1}); // at the edge, and a step
        QVERIFY2(m_window->text().contains("Camera eye { Body=b Pos=0.15,0.05,0.1 }"), m_window->text().constData());
        begin();
        drop("Box", "Box lid { Size=0.12,0.06,0.02 }", {}, {0.086, 0.067, 0.1}); // its edges at those of the face
        QVERIFY2(m_window->text().contains("Pos=0.09,0.07,0.11"), m_window->text().constData());
        begin();
        m_window->trigger("tool.snap");
        drop("Camera", "Camera eye { Body=b }", {}, {0.006, -0.005, 0.1});
        m_window->trigger("tool.snap");
        QVERIFY2(!m_window->text().contains("Pos=0,0,0.1"), m_window->text().constData());
    }

    void aRowOfTheTreeMovesItsObject() {
        m_window->selection.select("robot0");
        QCOMPARE(dropRows({"robot0"}, {0.2, -0.7, 0}), Qt::MoveAction);
        QVERIFY2(m_window->text().contains("Robot robot0 { Config=SimpleRobot Pos=0.2,-0.7,0 HPR=0,0,0 } // the first"),
                 m_window->text().constData());
        QCOMPARE(m_window->document.loaded()->experiment->robots.size(), std::size_t(2));
        QCOMPARE(m_window->document.edits().history().entries().size(), std::size_t(1));
        m_window->document.edits().undo();
        QCOMPARE(m_window->text(), kRoom);
    }

    /// Beside or on another robot, and in its place once that is hidden.
    void whatIsHiddenIsNotInTheWay() {
        m_window->selection.select("robot0");
        QCOMPARE(dropRows({"robot0"}, {0.5, 0.3, 0}), Qt::MoveAction);
        const Vec3 beside = m_window->document.loaded()->experiment->robots.at(0).pose.position;
        QVERIFY2((beside - Vec3(0.5, 0.3, 0)).norm() > 0.1, m_window->text().constData());
        m_window->document.edits().undo();
        m_window->panel->world().setHidden({"robot1"});
        QCOMPARE(dropRows({"robot0"}, {0.5, 0.3, 0}), Qt::MoveAction);
        QVERIFY2(m_window->text().contains("Pos=0.5,0.3,0 HPR=0,0,0 } // the first"), m_window->text().constData());
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
        QCOMPARE(m_window->document.edits().history().entries().size(), std::size_t(1));
    }

    void reportsUnmovableObjects() {
        QVERIFY(m_window->open(QByteArray(kRoom).replace("Robot robot1 {", "Grid robot1 { Count=2,1 Spacing=1,1")));
        const QByteArray before = m_window->text();
        m_window->selection.select("robot1_0");
        QCOMPARE(dropRows({"robot1_0"}, {0.2, -0.7, 0}), Qt::MoveAction);
        QCOMPARE(m_window->text(), before);
        QCOMPARE(m_window->refusals.size(), std::size_t(1));
    }

    void dropFromOtherWindowCopies() {
        m_window->selection.select("robot0");
        QCOMPARE(dropRows({"robot0"}, {0.2, -0.7, 0}, {}, "1 "), Qt::CopyAction);
        QCOMPARE(m_window->document.loaded()->experiment->robots.size(), std::size_t(3));
    }

    void rejectsUnknownMimeData_data() {
        QTest::addColumn<QByteArray>("json");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("no JSON") << QByteArray("Robot x {");
        QTest::newRow("no text") << QByteArray("{\"kind\":\"Robot\"}");
        QTest::newRow("unknown kind") << QByteArray("{\"kind\":\"Dragon\",\"text\":\"Dragon d { }\"}");
        QTest::newRow("broken text") << QByteArray("{\"kind\":\"Robot\",\"text\":\"} } Robot {\"}");
        QTest::newRow("a list") << QByteArray("[1,2,3]");
        QTest::newRow("numbers for words") << QByteArray("{\"kind\":3,\"text\":7,\"imports\":9}");
    }
    void rejectsUnknownMimeData() {
        QFETCH(const QByteArray, json);
        QMimeData data;
        data.setData(QStringLiteral("application/x-trundle-library"), json);
        LibraryDrop(m_window->view(), data, false).drop({300, 300});
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

    static void fill(QMimeData& data, const char* kind, const char* text, const QStringList& imports, bool isTemplate = false) {
        const QJsonObject json{{QStringLiteral("kind"), QLatin1String(kind)},
                               {QStringLiteral("text"), QLatin1String(text)},
                               {QStringLiteral("imports"), QJsonArray::fromStringList(imports)},
                               {QStringLiteral("isTemplate"), isTemplate}};
        data.setData(QStringLiteral("application/x-trundle-library"), QJsonDocument(json).toJson());
    }

    void drop(const char* kind, const char* text, const QStringList& imports, const Vec3& where, bool isTemplate = false) {
        QMimeData data;
        fill(data, kind, text, imports, isTemplate);
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
