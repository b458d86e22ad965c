// What the wizards write and choose, at the edges: each number in its place, limits from both sides.
#include <QTest>

#include <cmath>
#include <numbers>

#include "project/wizard/arena_text.h"
#include "project/wizard/floor_path.h"
#include "project/wizard/heights_text.h"
#include "project/wizard/mesh_text.h"
#include "project/wizard/robot_design.h"

using namespace trundle;

namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

HeightMap pixels(std::uint32_t columns, std::uint32_t rows, std::vector<float> heights) {
    return {columns, rows, std::move(heights)};
}

std::string failureOf(const RobotDesign& design) {
    const auto choice = chooseMotor(design);
    return choice ? std::string() : choice.error().message;
}

/// A motor of this torque behind its gear, N m.
GearMotor motorOf(double torque) {
    GearMotor motor = gearMotors()[0];
    motor.stallTorque = 2 * torque;
    motor.gearTorque = 1e9;
    return motor;
}

} // namespace

class WizardTextsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void wallsAreWhereThePlanHasThem() {
        FloorPlan plan;
        plan.columns = 20;
        plan.rows = 10;
        plan.cell = 0.1;
        plan.walls = {{0, 0, 4, 1}, {18, 5, 1, 4}};
        const std::string text = arenaText("Hall", plan, 0.5, "hall.png");
        QVERIFY2(has(text, "Box wall1 { Pos=-0.8,0.45,$(height/2) Size=0.4,0.1,$height "), text.c_str());
        QVERIFY2(has(text, "Box wall2 { Pos=0.85,-0.2,$(height/2) Size=0.1,0.4,$height "), text.c_str());
        ObstacleField field;
        field.length = 4;
        field.width = 2;
        field.count = 0;
        const std::string room = obstacleText("Room", field).value();
        for (const char* wall :
             {"north { Pos=0,1.05,$(height/2) Size=4.2,0.1,$", "south { Pos=0,-1.05,$(height/2) Size=4.2,0.1,$",
              "east { Pos=2.05,0,$(height/2) Size=0.1,2,$", "west { Pos=-2.05,0,$(height/2) Size=0.1,2,$"})
            QVERIFY2(has(room, wall), wall);
    }

    void roomsAreWhereTheyArePut() {
        RoomPlan room;
        room.height = 0.5;
        room.walls = {{"n", 0.25, 0.5, 2, 0.1}};
        for (const auto& [place, pos] : {std::pair(std::array{0., 1.}, " Pos=0,1,0"),
                                         {{-2., 0.}, " Pos=-2,0,0"},
                                         {{0.00016, 0.}, " Pos=0.0002,0,0"},
                                         {{0.00004, -0.00004}, ""}}) {
            const std::string text = roomBlocksText("Room", room, false, place);
            QVERIFY2(text.ends_with(std::string("Static room { Config=Room") + pos + " }\n"), text.c_str());
        }
        QCOMPARE(roomBoxesText(room, false, {1, -2}),
                 std::string("Box n { Pos=1.25,-1.5,0.25 Size=2,0.1,0.5 Material=wood Surface=wall }\n"));
        QVERIFY(has(arenaExperimentText("A", "a", {1, 2}, 1, 0.25), "Pos=1,2,0.25 }\nView overview { Eye=-0.15,-1.05,1.35 "));
    }

    void pathsThatTurnBackAndStylesOfPieces() {
        const auto back = piecesAlong({{0, 0}, {1, 0}, {0, 0}}, 0.1); // it is no ring
        QCOMPARE(back.size(), std::size_t(2));
        for (const FloorPiece& piece : back) QVERIFY(std::abs(piece.length - 1.05) < 1e-9);
        QCOMPARE(staticsText(piecesAlong({{-1, 0}, {1, 0}}, 0.1), wallPath()), std::string("Static wall1 { Config=Wall }\n"));
        FloorPathStyle style = linePath();
        style.bottom = 0.2;
        style.top = 0.6;
        QCOMPARE(boxesText(piecesAlong({{0, 0}, {1, 0}}, 0.1), style),
                 std::string("Box line1 { Pos=0.5,0,0.4 Size=1,0.018,0.4 Collide=false Material=black Surface=ground }\n"));
    }

    void groundsFromPictures() {
        QVERIFY(heightsText("a.png", {1e4, 0.001, 1}).ok() && !heightsText("a.png", {10001, 1, 1}).ok() &&
                !heightsText("a.png", {1, 1, 0.0009}).ok());
        QVERIFY(has(heightsText("hills9/Z-a_0.png", {1, 2, 3}).value(), "File=hills9/Z-a_0.png Size=1,2,3 "));
        QVERIFY(has(heightsText("my hills.png", {1, 2, 3}).value(), "File=\"my hills.png\" "));
        for (const char* name : {"a\\b.png", "a\nb.png", "a\"b.png"}) QVERIFY(!heightsText(name, {1, 1, 1}).ok());
        const HeightMap map = pixels(3, 3, {0, 0, 0, 0, 0.5f, 0, 1, 0, 0});
        QCOMPARE(heightAt(map, {30, 30, 2}, {0, -15}, 0.1), 0.);
        QCOMPARE(heightAt(map, {30, 30, 2}, {8, 0}, 0.1), 1.);
        QCOMPARE(heightAt(map, {30, 30, 2}, {-15, -15}, 0.1), 2.);
        QCOMPARE(heightAt(map, {30, 30, 2}, {-15, 15}, 0.1), 0.);
    }

    void meshesAsText() {
        MeshPart part{.name = "cup", .file = "cup.obj", .mass = 2};
        QCOMPARE(meshGeomsText(part), std::string("Mesh cup { File=cup.obj Shape=hull Mass=2 Material=grey Surface=wall }\n"));
        part.scale = 0.001;
        part.isYUp = part.hasOwnLook = true;
        part.origin = {0.1, 0, 0};
        part.shape = {.kind = CollisionShape::Kind::Cylinder, .centre = {0, 0, 0.15}, .axis = 0, .radius = 0.1, .length = 0.3};
        const std::string head = "Mesh cup { File=cup.obj Scale=0.001 Pos=0.1,0,0 HPR=0,0,90 Shape=none Surface=wall }\n",
                          tail = " Visible=false Mass=2 Material=grey Surface=wall }\n";
        const char* const turns[] = {" HPR=0,90,0", " HPR=0,0,90", ""};
        for (int axis = 0; axis < 3; ++axis) {
            part.shape.axis = axis;
            for (const auto& [kind, word] :
                 {std::pair(CollisionShape::Kind::Cylinder, "Cylinder"), {CollisionShape::Kind::Capsule, "Capsule"}}) {
                part.shape.kind = kind;
                QCOMPARE(meshGeomsText(part),
                         head + word + " cupShape { Pos=0,0,0.15" + turns[axis] + " Radius=0.1 Length=0.3" + tail);
            }
        }
        part.shape = {.kind = CollisionShape::Kind::Sphere, .axis = 0, .radius = 0.1, .length = 0.3};
        QCOMPARE(meshGeomsText(part), head + "Sphere cupShape { Radius=0.1" + tail);
        part.shape = {.kind = CollisionShape::Kind::Box, .axis = 0, .size = {1, 2, 3}};
        QCOMPARE(meshGeomsText(part), head + "Box cupShape { Size=1,2,3" + tail);
        for (const auto& [file, name] :
             {std::pair("3d-cup zoo.obj", "dCupZoo"), {"azure zig.obj", "azureZig"}, {"Zed.obj", "zed"}, {"9.obj", "mesh"}})
            QCOMPARE(meshName(file), std::string(name));
    }

    /// The shares of hulls add up to the mass, and none is without any.
    void sharesOfHulls() {
        MeshPart part{.name = "cup", .file = "cup.obj", .mass = 1};
        part.shape = {.kind = CollisionShape::Kind::Hulls, .files = {"a.obj", "b.obj", "c.obj"}, .volumes = {1, 1, 1}};
        const std::string equal = meshGeomsText(part);
        QVERIFY2(has(equal, "a.obj Visible=false Mass=0.3333 ") && has(equal, "b.obj Visible=false Mass=0.3333 ") &&
                     has(equal, "c.obj Visible=false Mass=0.3334 "),
                 equal.c_str());
        part.shape.files.pop_back();
        part.shape.volumes = {1, 1e6};
        const std::string small = meshGeomsText(part);
        QVERIFY2(has(small, "a.obj Visible=false Mass=0.0001 ") && has(small, "b.obj Visible=false Mass=0.9999 "), small.c_str());
    }

    void obstaclesAreApart() {
        ObstacleField field;
        field.length = field.width = 12;
        field.count = 40;
        field.apart = 0.5;
        const auto placed = obstacleField(field).value();
        for (std::size_t i = 0; i < placed.size(); ++i)
            for (std::size_t k = 0; k < i; ++k) {
                const auto radius = [](const FieldObstacle& o) {
                    return (o.isRound ? o.across : std::hypot(o.across, o.deep)) / 2;
                };
                const double gap =
                    std::hypot(placed[i].x - placed[k].x, placed[i].y - placed[k].y) - radius(placed[i]) - radius(placed[k]);
                QVERIFY(gap >= 0.5);
            }
        field.length = field.width = 1000;
        field.count = 2000;
        QCOMPARE(obstacleField(field).value().size(), std::size_t(2000));
        field.count = 2001;
        QVERIFY(!obstacleField(field).ok());
        field.count = 1;
        field.least = 0.5;
        field.most = 0.5;
        QVERIFY(obstacleField(field).ok());
        field.most = 0.49;
        QVERIFY(!obstacleField(field).ok());
        ObstacleField full;
        full.length = full.width = 2;
        full.count = 500;
        const std::string message = obstacleField(full).error().message;
        full.count = std::atoi(message.substr(message.find("the room has ") + 13).c_str());
        QVERIFY(full.count > 0 && obstacleField(full).ok());
        ++full.count;
        QVERIFY(!obstacleField(full).ok());
    }

    /// What is as grey as the threshold is no wall; a plan of as many boxes as it may have stays as it is, one of more is halved.
    void limitsOfPlans() {
        FloorPlanOptions options;
        options.threshold = 0.5;
        options.width = 6;
        const HeightMap row = pixels(3, 1, {0, 0.5f, 0});
        options.mostBoxes = 2;
        const FloorPlan exact = floorPlanFrom(row, options).value();
        QVERIFY(exact.walls.size() == 2 && exact.step == 1 && exact.columns == 3 && exact.cell == 2);
        options.mostBoxes = 1;
        const FloorPlan half = floorPlanFrom(row, options).value(); // of two cells one is wall; the last one is alone
        QVERIFY(half.walls.size() == 1 && half.step == 2 && half.columns == 2 && half.cell == 4);
        QVERIFY(half.walls[0].width == 2 && half.walls[0].height == 1);
        options.mostBoxes = 2;
        options.isInverted = true;
        const FloorPlan other = floorPlanFrom(row, options).value();
        QVERIFY(other.walls.size() == 1 && other.walls[0].x == 1);
    }

    void whatABaseClimbs_data() {
        QTest::addColumn<int>("base");
        QTest::addColumn<double>("grip");   // tangent of the steepest slope with a strong motor
        QTest::addColumn<double>("wheels"); // that push, with a weak one
        QTest::newRow("differential") << int(BaseShape::Differential) << 0.7 << 2.;
        QTest::newRow("skid-steer") << int(BaseShape::SkidSteer) << 1. << 4.;
        QTest::newRow("omni") << int(BaseShape::Omni) << 0.4 << 1.5;
        QTest::newRow("car") << int(BaseShape::Ackermann) << 0.5 << 2.;
        QTest::newRow("mecanum") << int(BaseShape::Mecanum) << 0.8 / std::numbers::sqrt2 << 4.;
    }
    void whatABaseClimbs() {
        QFETCH(int, base);
        QFETCH(double, grip);
        QFETCH(double, wheels);
        RobotDesign design = usualDesign(BaseShape(base));
        design.height = 0.01;
        design.length = 2; // it does not tip over
        design.wheelSeparation = design.wheelBase = 2;
        QVERIFY(std::abs(std::tan(reachedWith(motorOf(1000), design).slope) - grip) < 1e-9);
        const double torque = 0.001, push = wheels * torque / design.wheelRadius;
        QVERIFY(std::abs(std::sin(reachedWith(motorOf(torque), design).slope) - push / (design.mass * 9.81)) < 1e-9);
        design.height = 3; // it tips over first
        design.length = design.wheelSeparation = design.wheelBase = 0.5;
        QVERIFY(std::tan(reachedWith(motorOf(1000), design).slope) < grip);
        GearMotor geared = motorOf(1);
        QCOMPARE(geared.usableTorque(), 1.);
        geared.gearTorque = 0.25;
        QCOMPARE(geared.usableTorque(), 0.25);
    }

    void limitsOfDesigns() {
        RobotDesign design;
        design.topSpeed = 20;
        QVERIFY2(failureOf(design).starts_with("No motor is fast enough"), failureOf(design).c_str());
        design.topSpeed = 20.1;
        QVERIFY2(failureOf(design).starts_with("The top speed must be from"), failureOf(design).c_str());
        design = {};
        design.wheelBase = 0; // it has none
        QCOMPARE(failureOf(design), std::string());
        RobotDesign car = usualDesign(BaseShape::Ackermann);
        car.wheelSeparation = 1;
        car.wheelBase = 0.59;
        QVERIFY2(failureOf(car).starts_with("The wheelbase must be at least 0.6 m"), failureOf(car).c_str());
        RobotDesign narrow;
        narrow.length = 2;
        narrow.width = 0.05;
        narrow.wheelSeparation = 0.15;
        narrow.height = 1;
        QVERIFY2(failureOf(narrow).starts_with("It would tip over"), failureOf(narrow).c_str());
        RobotDesign tall; // on the slope it would stay, but not where it brakes
        const double footing = std::min(0.18 * tall.length, tall.wheelSeparation / 2),
                     slope = std::tan(kLeastSlopeDeg * std::numbers::pi / 180);
        tall.height = 2 * (footing / (slope + 0.05) - groundClearance(tall));
        QVERIFY2(failureOf(tall).starts_with("It would tip over when it brakes"), failureOf(tall).c_str());
        RobotDesign exact;
        exact.mass = 0.5;
        exact.topSpeed = reachedWith(gearMotors()[0], exact).topSpeed;
        QVERIFY(chooseMotor(exact).value().motor.name == gearMotors()[0].name);
    }

    void limitsOfRoomsAndMazes() {
        RoomOptions room;
        room.length = 1;
        room.width = 4;
        room.thickness = 0.1;
        room.doorSide = RoomSide::East;
        room.doorWidth = 2;
        const RoomPlan plan = roomPlan(room).value();
        QVERIFY(std::abs(plan.length - 1.2) < 1e-12 && std::abs(plan.width - 4.2) < 1e-12);
        room.doorWidth = 4;
        QVERIFY(!roomPlan(room).ok());
        room.doorSide = RoomSide::North;
        room.doorWidth = 2;
        QVERIFY(!roomPlan(room).ok());
        MazeOptions maze;
        maze.rows = 2;
        maze.columns = 5;
        maze.cell = 0.5;
        maze.thickness = 0.25;
        const RoomPlan small = mazePlan(maze).value();
        QVERIFY(std::abs(small.length - 2.75) < 1e-12 && std::abs(small.width - 1.25) < 1e-12);
        QVERIFY(std::abs(small.startX + 1) < 1e-12 && std::abs(small.startY + 0.25) < 1e-12);
        maze.thickness = 0.26;
        QVERIFY(!mazePlan(maze).ok());
        maze = {};
        maze.rows = 100;
        maze.columns = 1;
        QVERIFY(mazePlan(maze).ok());
        maze.rows = 101;
        QVERIFY(!mazePlan(maze).ok());
        maze.rows = maze.columns = 8;
        QStringList texts;
        for (maze.seed = 1; maze.seed <= 4; ++maze.seed)
            texts += QString::fromStdString(roomText("Maze", mazePlan(maze).value(), "a maze"));
        texts.removeDuplicates();
        QCOMPARE(texts.size(), 4);
    }
};

QTEST_APPLESS_MAIN(WizardTextsTest)
#include "wizard_texts_test.moc"
