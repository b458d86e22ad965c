// The Insert menu: offers the registered kinds where they are allowed.

#include <QMenu>

#include "check/model_check.h"
#include "editor/outline/free_places.h"
#include "editor/outline/insert_menu.h"
#include "eventually.h"
#include "model/passive_objects.h"
#include "model/resolve/footprint.h"
#include "outline_fixture.h"

using namespace trundle;

namespace {

const QByteArray kWithController = "#loadModule controllers/linear_motion\n" + kRovers;

/// What the model check reports.
QString findingsOf(const OutlineFixture& o) {
    Diagnostics found;
    checkModel(*o.document.loaded(), found);
    QStringList all;
    for (const Diagnostic& d : found.all()) all.append(QString::fromStdString(codeName(d.code) + " " + d.message));
    return all.join(QLatin1Char('\n'));
}

/// The selection under which a block of the kind can be inserted.
const char* placeFor(const Kind& kind) {
    if (kind.name == "Part" || kind.role == Role::Repeat) return "RobotConfig.Rover";
    switch (kind.role) {
    case Role::Body:
    case Role::Joint:
    case Role::Device: return "RobotConfig.Rover";
    case Role::Geom:
        return std::ranges::find(kind.parents, "Body") != kind.parents.end() ? "RobotConfig.Rover.chassis" : "StaticConfig.Floor";
    case Role::Controller: return "robot0";
    default: return "";
    }
}

QAction* entry(QMenu& menu, const char* kind) {
    return menu.findChild<QAction*>(QStringLiteral("insert.") + QLatin1String(kind));
}

} // namespace

class InsertTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void insertsEveryKindWhereAllowed_data();
    void insertsEveryKindWhereAllowed();
    void offersWhatFitsTheSelection();
    void offersWhatFitsAPart();
    void newObjectsStandFree();
    void newShapesStandFree_data();
    void newShapesStandFree();
    void theFloorIsInTheWayOfRobotsOnly();
    void robotsStandBesideThinThings();
    void aHullHasRoomForWheels();
    void newObjectsComeToTheInsertionPoint();
    void aRobotMayHaveSeveralControllers();
    void objectsAreMovable_data();
    void objectsAreMovable();
    void aMenuFollowsTheSelection();
};

void InsertTest::insertsEveryKindWhereAllowed_data() {
    QTest::addColumn<QByteArray>("kind");
    const OutlineFixture o;
    Document document(*o.application);
    QVERIFY(o.write("kinds.sim", kWithController));
    QVERIFY(document.opening().open(o.folder.filePath(QStringLiteral("kinds.sim")).toStdString()).ok());
    int controllers = 0;
    for (const Kind* kind : document.loaded()->registry->all()) {
        if (kind->role == Role::Settings) continue;
        controllers += kind->role == Role::Controller;
        QTest::newRow(kind->name.c_str()) << QByteArray::fromStdString(kind->name);
    }
    QCOMPARE(controllers, 1); // kinds of modules are listed with the others
}

void InsertTest::insertsEveryKindWhereAllowed() {
    QFETCH(QByteArray, kind);
    OutlineFixture o;
    QVERIFY(o.open(kWithController));
    QCOMPARE(o.errors(), QString());
    o.selection.select(placeFor(*o.document.loaded()->registry->find(kind.toStdString())));
    InsertMenu insert(o.document, o.selection, o.edits);
    QMenu menu;
    insert.fill(menu);
    QAction* action = entry(menu, kind);
    QVERIFY(action);
    QVERIFY(action->isEnabled());
    QVERIFY(!action->toolTip().isEmpty());
    action->trigger();
    QCOMPARE(o.refusals, QStringList());
    QVERIFY(o.text() != kWithController);
    QCOMPARE(o.selection.paths().size(), std::size_t(1));
    const QModelIndex row = o.at(o.selection.current().c_str());
    QVERIFY(row.isValid());
    QCOMPARE(QByteArray::fromStdString(o.model().rowAt(row)->part->block->type.text), kind);
    QVERIFY(o.document.edits().history().entries().back().name.startsWith(QStringLiteral("Add ") + QLatin1String(kind)));
    EVENTUALLY_EQUAL(o.errors(), QString()); // meshes are read by a worker thread
    o.document.edits().undo();
    QCOMPARE(o.text(), kWithController);
}

/// A body of a Part takes shapes, its PartConfig the rest.
void InsertTest::offersWhatFitsAPart() {
    OutlineFixture o;
    QVERIFY(o.open(kRovers + "PartConfig Arm { Body rod { Box bar { Size=0.1,0.02,0.02 Mass=0.1 } }\n"
                             "  Fixed weld { Parent=$on Child=rod } }\n"
                             "RobotConfig Armed { Config=Rover Part arm { Config=Arm Pos=0,0,0.5 on=chassis } }\nRobot armed { Config=Armed }\n"));
    QCOMPARE(o.errors(), QString());
    InsertMenu insert(o.document, o.selection, o.edits);
    o.selection.select("armed.arm.rod.bar");
    QMenu menu;
    insert.fill(menu);
    QStringList places;
    for (const QAction* action : menu.actions())
        if (action->objectName().startsWith(u"insertPlace."_qs)) places.append(action->objectName().mid(12));
    QCOMPARE(places, QStringList({u"PartConfig.Arm.rod"_qs, u"PartConfig.Arm"_qs, QString()}));
    const auto* more = menu.findChild<QMenu*>(u"insertMore"_qs); // of the experiment, what is seldom inserted
    QVERIFY(more && more->actions().contains(entry(menu, "Light")));
    QVERIFY(menu.actions().indexOf(more->menuAction()) > menu.actions().indexOf(entry(menu, "Static")));
    QVERIFY(menu.actions().contains(entry(menu, "Robot")) && menu.actions().contains(entry(menu, "Body")));
    entry(menu, "Box")->trigger();
    QCOMPARE(o.errors(), QString());
    QCOMPARE(o.selection.current(), std::string("armed.arm.rod.box"));
    QVERIFY2(o.text().indexOf("Box box") < o.text().indexOf("Fixed weld"), o.text());
}

void InsertTest::offersWhatFitsTheSelection() {
    OutlineFixture o;
    QVERIFY(o.open(kRovers));
    InsertMenu insert(o.document, o.selection, o.edits);
    const auto offers = [&](const char* path, const char* kind) {
        o.selection.select(path);
        QMenu menu;
        insert.fill(menu);
        return entry(menu, kind) != nullptr;
    };
    QVERIFY(offers("", "Robot"));
    QVERIFY(!offers("", "Box"));
    QVERIFY(!offers("", "Gear"));
    QVERIFY(offers("", "Hinge")); // between robots
    QVERIFY(offers("RobotConfig.Rover.chassis", "Box"));
    QVERIFY(!offers("RobotConfig.Rover.chassis", "Plane"));
    QVERIFY(offers("RobotConfig.Rover.chassis.hull", "Box")); // as a sibling
    QVERIFY(offers("RobotConfig.Rover.chassis", "Hinge"));    // into its parent
    QVERIFY(offers("robot0", "Body"));                        // into its config
    QVERIFY(offers("arena", "Plane"));
    QVERIFY(!offers("robot0", "LinearMotion")); // its module is not loaded
}

void InsertTest::objectsAreMovable_data() {
    QTest::addColumn<QString>("shape");
    for (const char* shape : {"Box", "Sphere", "Cylinder", "Capsule"}) QTest::newRow(shape) << QString::fromLatin1(shape);
}

/// For any selection: inserts a config and a Robot that rests on the ground, shown as one object.
void InsertTest::objectsAreMovable() {
    QFETCH(QString, shape);
    OutlineFixture o;
    QVERIFY(o.open(kRovers));
    for (int count = 1; count <= 2; ++count) { // the second one gets unique names
        o.selection.select("robot0");
        InsertMenu insert(o.document, o.selection, o.edits);
        QMenu menu;
        insert.fill(menu);
        auto* objects = menu.findChild<QMenu*>(QStringLiteral("insertObjects"));
        QVERIFY(objects && !objects->icon().isNull());
        auto* action = objects->findChild<QAction*>(QStringLiteral("insertObject.") + shape);
        QVERIFY(action && !action->icon().isNull());
        const std::size_t before = o.document.loaded()->experiment->robots.size();
        action->trigger();
        QCOMPARE(o.refusals, QStringList());
        QCOMPARE(o.errors(), QString());
        QCOMPARE(o.document.loaded()->experiment->robots.size(), before + 1);
        const RobotSpec& made = o.document.loaded()->experiment->robots.back();
        QVERIFY(isPassive(made));
        QCOMPARE(o.selection.paths(), std::vector<std::string>{made.name});
        QCOMPARE(o.document.edits().history().entries().size(), std::size_t(count));
    }
    const QModelIndex row = o.at(o.selection.current().c_str());
    QVERIFY(o.model().rowAt(row)->passive);
    o.document.edits().undo();
    o.document.edits().undo();
    QCOMPARE(o.text(), kRovers);
}

/// Three boxes and a robot beside the robot at the origin: the model check has nothing to say, and each is one edit.
void InsertTest::newObjectsStandFree() {
    OutlineFixture o;
    QVERIFY(o.open(kRovers));
    InsertMenu insert(o.document, o.selection, o.edits);
    const QString before = findingsOf(o);
    std::size_t edits = 0;
    for (const char* name : {"insertObject.Box", "insertObject.Box", "insertObject.Box", "insert.Robot", "insert.Static"}) {
        o.selection.select("");
        QMenu menu;
        insert.fill(menu);
        auto* action = menu.findChild<QAction*>(QLatin1String(name));
        QVERIFY(action);
        action->trigger();
        QCOMPARE(o.refusals, QStringList());
        QCOMPARE(findingsOf(o), before);
        QCOMPARE(o.document.edits().history().entries().size(), ++edits);
    }
    for (const RobotSpec& robot : o.document.loaded()->experiment->robots) { // near, and on the floor
        QVERIFY(robot.pose.position.norm() < 1.5);
        QVERIFY(std::abs(robot.pose.position.z()) < 1e-4 || isPassive(robot));
    }
    const std::vector<std::string> last = o.selection.paths();
    QCOMPARE(last.size(), std::size_t(1));
    for (std::size_t i = 0; i < edits; ++i) o.document.edits().undo();
    QCOMPARE(o.text(), kRovers);
}

void InsertTest::newShapesStandFree_data() {
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("place");
    for (const char* kind : {"Box", "Sphere", "Cylinder", "Capsule"})
        for (const char* place : {"robot0.chassis", "RobotConfig.Rover.leftWheel"})
            QTest::addRow("%s in %s", kind, place) << QString::fromLatin1(kind) << QString::fromLatin1(place);
    QTest::newRow("Hinge with its body") << QStringLiteral("Hinge") << QStringLiteral("robot0");
}

/// On top of the body or the robot: the model check has nothing to say.
void InsertTest::newShapesStandFree() {
    QFETCH(QString, kind);
    QFETCH(QString, place);
    OutlineFixture o;
    QVERIFY(o.open(kRovers));
    QCOMPARE(findingsOf(o), QString());
    QVERIFY(o.edits.insertKind(*o.document.loaded()->registry->find(kind.toStdString()), place.toStdString()).ok());
    QCOMPARE(o.errors(), QString());
    QCOMPARE(findingsOf(o), QString());
    QCOMPARE(o.document.edits().history().entries().size(), std::size_t(1));
    const auto& bodies = o.document.loaded()->experiment->robots[0].config->bodies;
    const auto& body = kind == u"Hinge" ? bodies.back() : place.endsWith(u"chassis") ? bodies[0] : bodies[1];
    const double top = kind == u"Hinge" || place.endsWith(u"chassis") ? 0.14 : 0.1; // of what was there
    const GeomSpec& geom = body.geoms.back();
    double low = HUGE_VAL;
    for (const Footprint& foot : footprintsOf(geom, body.pose)) low = std::min(low, foot.low);
    QVERIFY2(low > top - 1e-9 && low < top + 2e-3, o.text().constData());
}

/// Where nothing else is, a robot whose origin is its centre is raised onto the floor, and scenery stays in it.
void InsertTest::theFloorIsInTheWayOfRobotsOnly() {
    OutlineFixture o;
    const QByteArray floor = "StaticConfig Floor { Plane floor { } }\nStatic arena { Config=Floor }\n";
    const auto load = [&](const char* name, const QByteArray& text) {
        return o.write(name, text) ? o.application->open(o.folder.filePath(QLatin1String(name)).toStdString(), {}).value()
                                   : nullptr;
    };
    const auto before = load("before.sim", floor);
    const auto ball = load("ball.sim", floor + "RobotConfig Ball { Body b { Sphere s { Radius=0.2 Mass=1 } } }\n"
                                               "Robot ball { Config=Ball Pos=0,0,0 }\n");
    const auto block = load("block.sim", floor + "StaticConfig Block { Box b { Size=0.4,0.4,0.4 } }\n"
                                                 "Static block { Config=Block Pos=0,0,0 }\n");
    const std::vector<ValueEdit> raised = freePlaces(*before, *ball, std::nullopt);
    QCOMPARE(raised.size(), std::size_t(1));
    QCOMPARE(raised[0].path.text(), std::string("ball.Pos"));
    QVERIFY2(raised[0].value.text().starts_with("0,0,0.2"), raised[0].value.text().c_str());
    QVERIFY(freePlaces(*before, *block, std::nullopt).empty());
}

/// On top of what is smaller than they are they would tip over; a table holds them.
void InsertTest::robotsStandBesideThinThings() {
    OutlineFixture o;
    const auto load = [&](const char* name, const QByteArray& text) {
        return o.write(name, text) ? o.application->open(o.folder.filePath(QLatin1String(name)).toStdString(), {}).value()
                                   : nullptr;
    };
    const QByteArray floor = "StaticConfig Floor { Plane floor { } }\nStatic arena { Config=Floor }\n"
                             "RobotConfig Block { Body b { Box s { Size=0.3,0.2,0.1 Pos=0,0,0.05 Mass=1 } } }\n";
    for (const auto& [size, isOnTop] :
         {std::pair("0.1,2,0.5", false), {"2,0.1,0.5", false}, {"0.15,0.1,0.5", false}, {"1,1,0.5", true}}) {
        const QByteArray all =
            floor + "StaticConfig Thing { Box b { Size=" + size + " Pos=0,0,0.25 } }\nStatic thing { Config=Thing }\n";
        const auto before = load("before.sim", all), now = load("now.sim", all + "Robot r { Config=Block }\n");
        const std::vector<ValueEdit> edits = freePlaces(*before, *now, Vec3(0.02, -0.01, 0));
        QCOMPARE(edits.size(), std::size_t(1));
        QVERIFY2(edits[0].value.text().ends_with(",0.5") == isOnTop && edits[0].value.text().ends_with(",0") != isOnTop,
                 edits[0].value.text().c_str());
    }
}

/// A robot that is begun with its hull stays above the floor of its model, and keeps away from what wheels would touch.
void InsertTest::aHullHasRoomForWheels() {
    OutlineFixture o;
    const auto load = [&](const char* name, const QByteArray& text) {
        return o.write(name, text) ? o.application->open(o.folder.filePath(QLatin1String(name)).toStdString(), {}).value()
                                   : nullptr;
    };
    const QByteArray world = "StaticConfig Floor { Plane floor { } Box wall { Size=2,0.1,0.5 Pos=0,0.2,0.25 } }\n"
                             "Static arena { Config=Floor }\n",
                     model = "RobotConfig Mine { Body b { Box s { Size=0.3,0.2,0.1 Pos=0,0,0.09 Mass=1 } } }\n",
                     robot = "Robot r { Config=Mine }\n";
    const auto edits = freePlaces(*load("before.sim", world), *load("now.sim", world + model + robot), std::nullopt);
    QCOMPARE(edits.size(), std::size_t(1)); // the hull alone is free where it is, 50 mm beside the wall
    QVERIFY2(edits[0].value.text().ends_with(",0"), edits[0].value.text().c_str());
    const auto known = freePlaces(*load("before.sim", world + model), *load("now.sim", world + model + robot), std::nullopt);
    QVERIFY(known.empty()); // one that was there before
}

/// The middle of the 3D view, in the window. What is pasted keeps the position that is written.
void InsertTest::newObjectsComeToTheInsertionPoint() {
    OutlineFixture o;
    QVERIFY(o.open(kRovers));
    InsertMenu insert(o.document, o.selection, o.edits);
    o.edits.setInsertionPoint([] { return Vec3(-3.02, 2.11, 0.4); });
    for (const char* name : {"insertObject.Box", "insert.Robot"}) {
        o.selection.select("");
        QMenu menu;
        insert.fill(menu);
        menu.findChild<QAction*>(QLatin1String(name))->trigger();
        QCOMPARE(o.refusals, QStringList());
    }
    const ExperimentSpec& experiment = *o.document.loaded()->experiment;
    const Vec3 box = experiment.robots.at(2).pose.position, robot = experiment.robots.at(3).pose.position;
    QVERIFY2((box.head<2>() - Eigen::Vector2d(-3, 2.1)).norm() < 1e-9, o.text().constData());
    const double way = (robot.head<2>() - box.head<2>()).norm(); // beside the box
    QVERIFY2(way > 0.05 && way < 1, o.text().constData());
    o.selection.select("robot0");
    o.edits.copySelected();
    o.document.edits().undo(), o.document.edits().undo();
    QVERIFY(o.edits.paste("").ok());
    QVERIFY(o.document.loaded()->experiment->robots.back().pose.position.norm() < 1.5);
}

void InsertTest::aRobotMayHaveSeveralControllers() {
    OutlineFixture o;
    QVERIFY(o.open(kWithController));
    InsertMenu insert(o.document, o.selection, o.edits);
    o.selection.select("robot0");
    QMenu first, second;
    insert.fill(first);
    entry(first, "LinearMotion")->trigger();
    QCOMPARE(o.errors(), QString());
    o.selection.select("robot0");
    insert.fill(second);
    entry(second, "LinearMotion")->trigger(); // which commands are whose is known when a run starts
    QCOMPARE(o.errors(), QString());
    QCOMPARE(o.document.loaded()->experiment->robots.at(0).controllers.size(), std::size_t(2));
}

void InsertTest::aMenuFollowsTheSelection() {
    OutlineFixture o;
    QMenu menu;
    InsertMenu insert(o.document, o.selection, o.edits);
    insert.attach(menu);
    QVERIFY(!menu.isEmpty()); // a disabled entry explains what to do first
    QVERIFY(!entry(menu, "Robot"));
    QVERIFY(o.open(kRovers));
    menu.popup({});
    QVERIFY(entry(menu, "Robot"));
    menu.close();
    QVERIFY(!entry(menu, "Sphere"));
    o.selection.select("robot1.chassis");
    menu.popup({});
    QVERIFY(entry(menu, "Sphere"));
    menu.close();
    entry(menu, "Sphere")->trigger();
    QVERIFY2(o.selection.current().starts_with("robot1.chassis.sphere"), o.selection.current().c_str());
}

QTEST_MAIN(InsertTest)
#include "insert_test.moc"
