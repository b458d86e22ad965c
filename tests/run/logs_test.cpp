// Content of the log files.
#include <QtTest>

#include "run/fake_world.h"
#include "run/logs/log_choice.h"
#include "run/logs/log_kinds.h"
#include "run/logs/signal_columns.h"

using namespace trundle;

class LogsTest : public QObject {
    Q_OBJECT

    static std::string csvOf(FakeWorld& world, const ComponentSpec& spec) {
        Diagnostics diagnostics;
        const std::unique_ptr<RunLog> log = makeLog(spec, world, diagnostics);
        if (diagnostics.hasErrors()) return diagnostics.all()[0].message;
        std::string csv;
        log->header(csv);
        log->rows(world, 0.5, csv);
        return csv;
    }
    static ComponentSpec contactLog(std::vector<std::string> robots) {
        return logSpec("ContactLog", "c", {{"Robot", textValue(std::move(robots))}});
    }

private Q_SLOTS:
    void aPoseLogOfAllRobots() {
        FakeWorld world(experimentOf({"robot0", "robot1"}));
        QCOMPARE(csvOf(world, logSpec("PoseLog", "path", {})),
                 std::string("time [s],robot,x [m],y [m],z [m],heading [deg],pitch [deg],roll "
                             "[deg]\n0.5,robot0,0,0,0,0,0,0\n0.5,robot1,0,1,0,0,0,0\n"));
    }
    void aPoseLogOfAGridByItsName() {
        FakeWorld world(experimentOf({"swarm_0", "swarm_1", "swarm_x", "other", "swarm12", "swarm_", "swarm_1_2"}));
        const std::string csv = csvOf(world, logSpec("PoseLog", "path", {{"Robot", textValue({"swarm"})}}));
        QVERIFY(csv.find("swarm_1,") != std::string::npos);
        for (const char* other : {"swarm_x", "swarm12", "swarm_,", "swarm_1_2"})
            QVERIFY2(csv.find(other) == std::string::npos, other);
        QVERIFY(csv.find("other") == std::string::npos);
    }
    /// A robot with a name of its own is no member of one whose name is the beginning of that.
    void aRobotHasNoMembers() {
        const auto chosen = [](const std::string& name) {
            Diagnostics diagnostics;
            const std::vector<RobotSpec> robots =
                experimentOf({"cart", "cart_2", "row_0.cart", "row_0.cart_2", "row_1.cart", "row_1.cart_2"})->robots;
            return chooseRobots(logSpec("PoseLog", "path", {{"Robot", textValue({name})}}), robots, diagnostics);
        };
        QCOMPARE(chosen("cart"), std::vector<std::size_t>{0});
        QCOMPARE(chosen("cart_2"), std::vector<std::size_t>{1});
        QCOMPARE(chosen("row.cart"), (std::vector<std::size_t>{2, 4}));
        QCOMPARE(chosen("row_1.cart"), std::vector<std::size_t>{4});
        QCOMPARE(chosen("cart*"), (std::vector<std::size_t>{0, 1}));
    }
    void unknownRobotListsExisting() {
        FakeWorld world(experimentOf({"robot0", "robot1"}));
        QCOMPARE(csvOf(world, logSpec("PoseLog", "path", {{"Robot", textValue({"robbot0"})}})),
                 std::string("no robot is called 'robbot0'; there are robot0, robot1"));
        Diagnostics diagnostics;
        (void)makeLog(logSpec("PoseLog", "path", {{"Robot", textValue({"robbot0"})}}), world, diagnostics);
        QCOMPARE(diagnostics.all()[0].suggestions.at(0), std::string("robot0"));
    }
    /// It is reported at the robot.
    void aRobotWhoseNameIsBrokenIsNotReportedTwice() {
        for (const char* broken : {"my rover", "2rover"}) {
            Diagnostics diagnostics;
            (void)chooseRobots(logSpec("PoseLog", "path", {{"Robot", textValue({"rover"})}}), experimentOf({broken})->robots,
                               diagnostics);
            QVERIFY(diagnostics.all().empty());
        }
    }
    void aMemberThatThereIsNot() {
        const std::vector<RobotSpec> robots = experimentOf({"cart_0", "cart_1", "row_0.cart", "row_1.cart"})->robots;
        Diagnostics diagnostics;
        (void)chooseRobots(logSpec("PoseLog", "path", {{"Robot", textValue({"row_2.cart", "cart_2"})}}), robots, diagnostics);
        QCOMPARE(diagnostics.all().at(0).message,
                 std::string("no robot is called 'row_2.cart'; row has no member row_2, the last one is row_1"));
        QCOMPARE(diagnostics.all()[0].suggestions, std::vector<std::string>{"row_1.cart"});
        QCOMPARE(diagnostics.all().at(1).message, // they have names of their own
                 std::string("no robot is called 'cart_2'; there are cart_0, cart_1, row.cart"));
    }
    /// The table names pictures that are beside it.
    void picturesOfATableInAFolder() {
        FakeWorld world(experimentOf({"robot0"}));
        for (const auto& [table, folder] : {std::pair("sub/deep/f.csv", "sub/deep/"), {"f.csv", ""}}) {
            Diagnostics diagnostics;
            const auto log = makeLog(logSpec("FrameLog", "film", {{"File", textValue({table})}}), world, diagnostics);
            std::vector<std::string> saved;
            log->usePictures([&](const PictureOptions&, const std::string& name) {
                saved.push_back(name);
                return Result<double>(0.25);
            });
            std::string csv;
            log->rows(world, 0.5, csv);
            QCOMPARE(csv, std::string("0.25,film_000000.jpg\n"));
            QCOMPARE(saved, std::vector<std::string>{std::string(folder) + "film_000000.jpg"});
        }
    }
    void anEnergyLog() {
        FakeWorld world(experimentOf({"robot0"}));
        QCOMPARE(csvOf(world, logSpec("EnergyLog", "e", {})),
                 std::string("time [s],robot,kinetic [J],potential [J],total [J]\n0.5,robot0,0.5,2,2.5\n"));
    }
    void aContactLogOfOneRobot() {
        FakeWorld world(experimentOf({"robot0", "robot1"}));
        world.touching = {{"robot0/chassis/bumper", "arena/north", {1, 2, 3}, {0, -1, 0}, 0.001, 5, {1.5, 0, -2}},
                          {"robot1/wheel/tyre", "arena/floor", Vec3::Zero(), Vec3::UnitZ(), 0, 0}};
        QCOMPARE(csvOf(world, contactLog({"robot0"})),
                 std::string("time [s],first,second,x [m],y [m],z [m],normal x,normal y,normal z,depth [m],force [N],"
                             "friction x [N],friction y [N],friction z [N]\n"
                             "0.5,robot0/chassis/bumper,arena/north,1,2,3,0,-1,0,0.001,5,1.5,0,-2\n"));
        QVERIFY(csvOf(world, logSpec("ContactLog", "c", {})).find("robot1/wheel/tyre") != std::string::npos);
    }
    /// Rows of a robot that has ended are left out, and its signals are empty.
    void logsOfEndedRobots() {
        FakeWorld world(experimentOf({"robot0", "robot1"}));
        world.faults.ends = {{0, {"robot0/chassis", 0.25, "torn", {}}}};
        const auto lines = [&](const ComponentSpec& spec) { return QString::fromStdString(csvOf(world, spec)).split(u'\n'); };
        const auto poses = lines(logSpec("PoseLog", "p", {})), energies = lines(logSpec("EnergyLog", "e", {}));
        QVERIFY(poses.size() == 3 && poses[1].startsWith("0.5,robot1,"));
        QVERIFY(energies.size() == 3 && energies[1].startsWith("0.5,robot1,"));
        QCOMPARE(lines(logSpec("SignalLog", "s", {{"Signals", textValue({"*/arm/position"})}}))[1], QStringLiteral("0.5,,0"));
    }
    void aSignalLogConvertsAnglesAndSpreadsPoses() {
        FakeWorld world(experimentOf({"robot0"}));
        world.block().slots()[world.layout().find("robot0/arm/position")->offset] = 1.5707963267948966;
        const auto pose = world.block().slots().subspan(world.layout().find("robot0/pose")->offset, 7);
        pose[0] = 4;
        pose[3] = 1; // w
        QCOMPARE(csvOf(world, logSpec("SignalLog", "s",
                                      {{"Signals", textValue({"robot0/arm/*", "robot0/pose", "robot0/arm/position"})}})),
                 std::string("time [s],robot0/arm/position [deg],robot0/pose/x [m],robot0/pose/y [m],robot0/pose/z "
                             "[m],robot0/pose/heading [deg],"
                             "robot0/pose/pitch [deg],robot0/pose/roll [deg]\n0.5,90,4,0,0,0,0,0\n"));
    }
    /// The columns of those that Trundle defines; a controller's own output with such a name has what it declares.
    void shapesOfSignals_data() {
        QTest::addColumn<std::string>("path");
        QTest::addColumn<std::string>("unit");
        QTest::addColumn<std::uint32_t>("count");
        QTest::addColumn<SignalDirection>("direction");
        QTest::addColumn<std::string>("last");
        const auto row = [](const char* name, const char* path, const char* unit, std::uint32_t count, SignalDirection direction,
                            const char* last) {
            QTest::newRow(name) << std::string(path) << std::string(unit) << count << direction << std::string(last);
        };
        constexpr auto kTruth = SignalDirection::Truth, kOutput = SignalDirection::Output;
        row("pose of a body", "r/b/pose", "m", 7, kTruth, "r/b/pose/roll [deg]");
        row("velocity of a robot", "r/velocity", "m/s", 6, kTruth, "r/velocity/z [rad/s]");
        row("pose of a drive", "r/base/pose", "", 3, kTruth, "r/base/pose/heading [deg]");
        row("odometry of a drive", "r/base/odometry", "", 3, kOutput, "r/base/odometry/heading [deg]");
        row("own pose", "r/c/pose", "m", 3, kOutput, "r/c/pose/2 [m]");
        row("own pose of seven numbers", "r/c/pose", "m", 7, kOutput, "r/c/pose/6 [m]");
        row("own odometry", "r/c/odometry", "m", 3, kOutput, "r/c/odometry/2 [m]");
        row("own velocity", "r/c/velocity", "m/s", 6, kOutput, "r/c/velocity/5 [m/s]");
    }
    void shapesOfSignals() {
        QFETCH(std::string, path);
        QFETCH(std::string, unit);
        QFETCH(std::uint32_t, count);
        QFETCH(SignalDirection, direction);
        QFETCH(std::string, last);
        const SignalColumns columns({path, unit, SignalType::Real, direction, 0, count});
        QCOMPARE(columns.names().back(), last);
        std::vector<double> numbers;
        columns.read(std::vector<double>{1, 2, 3, 4, 5, 6, 7}, numbers);
        QCOMPARE(numbers.size(), columns.names().size());
        QCOMPARE(numbers.back() == static_cast<double>(count), last.find("deg") == std::string::npos);
    }
    void anUnknownSignalListsThoseOfItsRobot() {
        FakeWorld world(experimentOf({"robot0", "robot1"}));
        const std::string message = csvOf(world, logSpec("SignalLog", "s", {{"Signals", textValue({"robot1/tuch/pressed"})}}));
        QVERIFY2(message.find("robot1/touch/pressed") != std::string::npos, message.c_str());
        QVERIFY2(message.find("robot0/") == std::string::npos, message.c_str());
        QVERIFY(csvOf(world, logSpec("SignalLog", "s", {{"Signals", textValue({"nothing*"})}}))
                    .starts_with("no signal is called 'nothing*'"));
    }
    /// The name of a Grid is no signal of its own: the pattern of its members is suggested.
    void signalsOfAGrid() {
        FakeWorld world(experimentOf({"swarm_0", "swarm_1", "swarm"}));
        Diagnostics diagnostics;
        (void)makeLog(logSpec("SignalLog", "s", {{"Signals", textValue({"swarm_/pose", "pack/pose"})}}), world, diagnostics);
        FakeWorld grid(experimentOf({"pack_0", "pack_1"}));
        Diagnostics found;
        (void)makeLog(logSpec("SignalLog", "s", {{"Signals", textValue({"pack/pose"})}}), grid, found);
        QCOMPARE(found.all().size(), std::size_t{1});
        QCOMPARE(found.all()[0].suggestions, std::vector<std::string>{"pack_*/pose"});
        for (const Diagnostic& d : diagnostics.all()) QVERIFY(d.message.find("its members") == std::string::npos);
    }
    void wildcards_data() {
        QTest::addColumn<QString>("pattern");
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("matches");
        QTest::newRow("all") << "*"
                             << "a/b" << true;
        QTest::newRow("prefix") << "robot0/*"
                                << "robot0/a/b" << true;
        QTest::newRow("other prefix") << "robot0/*"
                                      << "robot1/a" << false;
        QTest::newRow("middle") << "*/touch/*"
                                << "robot0/touch/pressed" << true;
        QTest::newRow("one") << "robot?"
                             << "robot1" << true;
        QTest::newRow("one is not two") << "robot?"
                                        << "robot12" << false;
        QTest::newRow("backtracks") << "*ab*ab"
                                    << "aabxabab" << true;
        QTest::newRow("many stars") << "*a*a*a*a*a*a*a*a*b" << QString(200, 'a') << false;
        QTest::newRow("empty") << ""
                               << "" << true;
    }
    void wildcards() {
        QFETCH(QString, pattern);
        QFETCH(QString, text);
        QTEST(matchesWildcard(pattern.toStdString(), text.toStdString()), "matches");
    }
    void mistakesAreFoundWithoutAWorld() {
        auto experiment = experimentOf({"robot0"});
        experiment->logs = {logSpec("PoseLog", "a", {{"File", textValue({"../a.csv"})}}), logSpec("PoseLog", "b", {}),
                            logSpec("EnergyLog", "c", {{"File", textValue({"b.csv"})}, {"Robot", textValue({"nobody"})}})};
        Diagnostics diagnostics;
        checkLogs(*experiment, diagnostics);
        QCOMPARE(diagnostics.errorCount(), std::size_t(3));
        QCOMPARE(diagnostics.all()[0].code, Code::LogUnwritable);
        QCOMPARE(diagnostics.all()[1].code, Code::UnknownReference);
        QCOMPARE(diagnostics.all()[2].code, Code::DuplicateName);
    }
    void logKindsAreTopLevel() {
        Registry registry;
        QVERIFY(addLogKinds(registry).ok());
        for (const char* name : {"PoseLog", "SignalLog", "ContactLog", "EnergyLog"}) {
            const Kind* kind = registry.find(name);
            QVERIFY(kind);
            QVERIFY(kind->nameOptional);
            QVERIFY(kind->find("Interval") && kind->find("File"));
        }
        QVERIFY(registry.find("SignalLog")->find("Signals")->required);
    }
};

QTEST_APPLESS_MAIN(LogsTest)
#include "logs_test.moc"
