// A robot that is elsewhere: the world that stands for it here, and the other end of its connection as a script in a thread.
#include <QTemporaryDir>
#include <QtTest>

#include <deque>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <set>
#include <thread>

#include "app/application.h"
#include "base/platform/socket.h"
#include "remote/remote_devices.h"
#include "remote/remote_world.h"
#include "run/runner.h"

using namespace trundle;
using Json = nlohmann::ordered_json;

namespace {

constexpr double kPi = std::numbers::pi;

struct Signal {
    std::string path, direction;
    std::vector<double> values;
};

/// Answers as a driver or a served run with the robot "r" does. Its members are the test's again after join().
struct OtherEnd {
    std::vector<Signal> table; ///< of its signals
    bool hasController = false;
    std::string state = "paused";
    std::map<std::string, std::vector<std::vector<std::string>>> arrivals; ///< by radio: packets that arrive in each tick
    std::set<std::string> refuses;                                         ///< devices that send nothing

    std::vector<Json> requests;
    std::vector<std::string> sent; ///< the bytes of packets
    std::map<std::string, std::deque<std::string>> waiting;
    std::size_t ticks = 0;
    std::thread thread;

    ~OtherEnd() { join(); }
    void join() {
        if (thread.joinable()) thread.join();
    }
    Socket start() {
        auto [here, there] = std::move(Socket::pair().value());
        thread = std::thread([this, socket = std::move(there)]() mutable { serve(socket); });
        return std::move(here);
    }

private:
    std::vector<double>& valuesOf(const std::string& path) { return std::ranges::find(table, path, &Signal::path)->values; }
    void serve(Socket& socket) {
        FrameReader reader({1u << 20, 1u << 20});
        std::vector<char> bytes(1u << 16);
        for (;;) {
            SocketWait wait{socket.descriptor(), true};
            waitForSockets(std::span(&wait, 1), std::chrono::seconds(1));
            const auto got = socket.read(bytes);
            if (!got) return; // the program is done
            reader.add(std::span(bytes).first(*got));
            while (const auto frame = reader.next().value()) {
                Json request = Json::parse(frame->json);
                if (request["op"] == "send") sent.push_back(frame->bytes);
                std::string data, out;
                Json reply{{"id", request["id"]}, {"ok", true}};
                answer(request, reply, data);
                requests.push_back(std::move(request));
                appendFrame(out, reply.dump(), data);
                for (std::size_t done = 0; done < out.size();) {
                    const auto written = socket.write(std::string_view(out).substr(done));
                    if (!written) return;
                    done += *written;
                }
            }
        }
    }
    void answer(const Json& request, Json& reply, std::string& data) {
        const std::string operation = request["op"];
        if (operation == "status") reply.update({{"tick_s", 0.02}, {"state", state}});
        if (operation == "describe") {
            reply["controller"] = hasController ? Json{{"kind", "Other"}, {"name", "brain"}} : Json();
            for (const Signal& each : table) reply["signals"].push_back({{"path", each.path}, {"direction", each.direction}});
        }
        if (operation == "subscribe") {
            reply["subscription"] = 5;
            for (const Signal& each : table) reply["signals"].push_back({each.path, each.values.size()});
        }
        if (const auto commands = request.find("signals"); operation != "subscribe" && commands != request.end())
            for (const auto& [path, value] : commands->items())
                valuesOf(path) = value.is_array() ? value.get<std::vector<double>>() : std::vector{value.get<double>()};
        if (operation == "step") arrive();
        if (operation == "read" || operation == "step")
            for (const Signal& each : table)
                data.append(reinterpret_cast<const char*>(each.values.data()), each.values.size() * sizeof(double));
        if (operation == "send" && refuses.contains(request["device"])) reply = {{"id", request["id"]}, {"ok", false}};
        if (operation == "receive") {
            std::deque<std::string>& packets = waiting[request["device"]];
            reply["received"] = !packets.empty();
            if (packets.empty()) return;
            reply.update({{"time", 0.25}, {"rssi", -71.5}, {"lqi", 93}, {"from", 17}, {"to", 4}, {"sequence", 201}});
            data = packets.front();
            packets.pop_front();
        }
    }
    void arrive() {
        for (const auto& [radio, byTick] : arrivals) {
            std::deque<std::string>& packets = waiting[radio];
            if (ticks < byTick.size()) packets.insert(packets.end(), byTick[ticks].begin(), byTick[ticks].end());
            valuesOf(radio + "/pending") = {double(packets.size())};
        }
        ++ticks;
    }
};

/// The run of a text with the robot "r", whose body is at the other end.
class RemoteRun {
public:
    RemoteRun(const std::string& text, OtherEnd& end) : m_end(end) {
        const std::string path = (std::filesystem::path(m_folder.path().toStdString()) / "main.sim").string();
        std::ofstream(path) << "Engine = general   Tick = 0.02\n#import robots/simple_robot.sim\n" << text;
        m_loaded = m_application->open(path, {}).value();
        Diagnostics problems = m_loaded->diagnostics;
        RunOptions options;
        options.replaceWorld = [&](std::unique_ptr<World> described, Diagnostics& diagnostics) -> std::unique_ptr<World> {
            Result<std::unique_ptr<RobotLink>> link = RobotLink::open(end.start(), {"my-token", "r", 10, {}});
            if (!link) return diagnostics.error(link.error().code, {}, link.error().message), nullptr;
            auto world = std::make_unique<RemoteWorld>(std::move(described), std::move(link).value());
            m_world = world.get();
            return world;
        };
        if (!problems.hasErrors()) m_runner = m_application->makeRunner(*m_loaded, options, problems);
        for (const Diagnostic& each : problems.all())
            if (each.severity == Severity::Error) m_failure += each.message + "\n";
    }
    ~RemoteRun() { end(); }
    [[nodiscard]] const std::string& failure() const { return m_failure; }
    [[nodiscard]] RemoteWorld& world() { return *m_world; }
    bool tick() { return m_runner->tick().ok(); }
    void set(const std::string& path, double value, std::uint32_t element = 0) {
        m_runner->command(SignalCommand{path, value, element});
    }
    void end() {
        m_runner.reset();
        m_end.join();
    }

private:
    OtherEnd& m_end;
    QTemporaryDir m_folder;
    std::unique_ptr<Application> m_application = makeApplication();
    std::shared_ptr<const LoadedProject> m_loaded;
    std::unique_ptr<Runner> m_runner;
    RemoteWorld* m_world = nullptr;
    std::string m_failure;
};

const std::string kPost =
    "RobotConfig Post { Body hull { Box box { Size=0.2,0.2,0.1 Pos=0,0,0.06 Mass=1 } }\n"
    " Led lamp { Body=hull Pos=0,0,0.12 }\n Transceiver low { Body=hull }\n Transceiver high { Body=hull Pos=0,0,0.3 } }\n";

QString shown(const Json& json) { return QString::fromStdString(json.dump()); }

} // namespace

class RemoteWorldTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aRobotIsWhereItsOdometryHasGotToFromItsStart_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<double>("heading");
        QTest::addColumn<QString>("place");
        QTest::newRow("at the origin") << 0.0 << 0.0 << 0.0 << "";
        QTest::newRow("moved") << 1.5 << -2.0 << 0.0 << "Pos=1.5,-2,0";
        QTest::newRow("turned") << 0.0 << 0.0 << kPi / 2 << "HPR=90,0,0";
        QTest::newRow("both") << -0.5 << 4.0 << -2 * kPi / 3 << "Pos=-0.5,4,0 HPR=-120,0,0";
    }
    void aRobotIsWhereItsOdometryHasGotToFromItsStart() {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(double, heading);
        QFETCH(QString, place);
        OtherEnd end;
        end.table = {{"r/frontTouch/pressed", "output", {0}}, {"r/base/odometry", "output", {0.3, -0.1, 0.4}}};
        RemoteRun run("Robot r { Config=SimpleRobot " + place.toStdString() + " }\n", end);
        QVERIFY2(run.failure().empty(), run.failure().c_str());
        for (int tick = 0; tick < 2; ++tick) {
            const Pose pose = run.world().robotPose(0);
            const double c = std::cos(heading), s = std::sin(heading);
            QVERIFY(std::abs(pose.position.x() - (x + 0.3 * c + 0.1 * s)) < 1e-12);
            QVERIFY(std::abs(pose.position.y() - (y + 0.3 * s - 0.1 * c)) < 1e-12);
            QCOMPARE(pose.position.z(), 0.0);
            const Vec3 ahead = pose.rotation * Vec3::UnitX();
            QVERIFY((ahead - Vec3(std::cos(heading + 0.4), std::sin(heading + 0.4), 0)).norm() < 1e-12);
            QVERIFY(run.tick());
        }
    }

    /// A pose that the other end knows is taken as it is; with neither, the robot stays at its start.
    void aPoseComesBeforeOdometry() {
        const Quat turned = rotationFromHpr({1.2, 0, 0});
        const Signal pose{"r/pose", "truth", {3, -4, 5, turned.w(), turned.x(), turned.y(), turned.z()}},
            odometry{"r/base/odometry", "output", {0.3, -0.1, 0.4}}, wrong{"r/base/odometry", "output", {0.3, -0.1}};
        const std::vector<std::pair<std::vector<Signal>, Pose>> cases = {
            {{odometry, pose}, {Vec3(3, -4, 5), turned}},
            {{pose, odometry}, {Vec3(3, -4, 5), turned}},
            {{}, {Vec3(1, 2, 0), rotationFromHpr({kPi / 2, 0, 0})}},
            {{wrong}, {Vec3(1, 2, 0), rotationFromHpr({kPi / 2, 0, 0})}},
        };
        for (const auto& [given, expected] : cases) {
            OtherEnd end;
            end.table = given;
            RemoteRun run("Robot r { Config=SimpleRobot Pos=1,2,0 HPR=90,0,0 }\n", end);
            QVERIFY2(run.failure().empty(), run.failure().c_str());
            QVERIFY(run.tick());
            const Pose is = run.world().robotPose(0);
            QVERIFY((is.position - expected.position).norm() < 1e-12);
            QVERIFY(is.rotation.angularDistance(expected.rotation) < 1e-7);
            const auto& missing = run.world().missing();
            QVERIFY(std::ranges::none_of(missing, [](const std::string& path) { return path.ends_with("/pose"); })); // truth
            const BlockHeader& header = run.world().block().header();
            QCOMPARE(std::tuple(header.tick, header.time), std::tuple(std::uint64_t(1), 0.02));
            QCOMPARE(std::ranges::find(missing, "r/base/odometry") == missing.end(), given.size() == 2);
            QVERIFY(std::ranges::find(missing, "r/base/linearVelocity") != missing.end());
        }
    }

    /// In whatever ticks the controller takes them: each packet once, in order, and as many as wait. Nothing is asked of an empty radio.
    void allPacketsThatWaitAreReceived() {
        OtherEnd end;
        for (const std::string radio : {"r/low", "r/high"}) {
            end.table.push_back({radio + "/pending", "output", {0}});
            end.table.push_back({radio + "/address", "output", {radio == "r/low" ? 4.0 : 60000.0}});
        }
        const std::vector<std::size_t> arrive = {3, 2, 0, 4, 1, 2, 0, 5}, take = {3, 1, 0, 9, 9, 0, 9, 4};
        std::map<std::string, std::vector<std::string>> all;
        for (std::size_t tick = 0; tick < arrive.size(); ++tick)
            for (const std::string radio : {"r/low", "r/high"}) {
                auto& now = end.arrivals[radio].emplace_back();
                for (std::size_t i = 0; i < arrive[radio == "r/low" ? tick : arrive.size() - 1 - tick]; ++i) {
                    now.push_back(radio + std::to_string(tick) + std::string(i, 'x'));
                    all[radio].push_back(now.back());
                }
            }
        const auto arrivals = end.arrivals;
        RemoteRun run(kPost + "Robot r { Config=Post }\n", end);
        QVERIFY2(run.failure().empty(), run.failure().c_str());
        RemoteRadios radios(run.world());
        QVERIFY(!radios.find("r/lamp") && !radios.find("r/lo") && !radios.exists(2));
        std::map<std::string, std::vector<std::string>> got;
        std::map<std::string, std::size_t> waits;
        for (std::size_t tick = 0; tick < arrive.size(); ++tick) {
            QVERIFY(run.tick());
            for (const std::string path : {"r/low", "r/high"}) {
                const auto radio = radios.find(path);
                QVERIFY(radio && radios.exists(*radio));
                QCOMPARE(radios.address(*radio), path == "r/low" ? 4u : 60000u);
                waits[path] += arrivals.at(path)[tick].size();
                RadioPacket packet;
                for (std::size_t i = 0; i < take[tick] && waits[path] > 0; ++i, --waits[path]) {
                    QCOMPARE(radios.pending(*radio), waits[path]);
                    QVERIFY(radios.receive(*radio, packet));
                    got[path].emplace_back(packet.bytes.begin(), packet.bytes.end());
                    QCOMPARE(std::tuple(packet.time, packet.rssi, packet.lqi), std::tuple(0.25, -71.5, 93));
                    QCOMPARE(std::tuple(packet.from, packet.to, int(packet.sequence)), std::tuple(17u, 4u, 201));
                }
                QCOMPARE(radios.pending(*radio), waits[path]);
                if (waits[path] == 0) QVERIFY(!radios.receive(*radio, packet));
            }
        }
        run.end();
        std::size_t asked = 0;
        for (const Json& request : end.requests) asked += request["op"] == "receive" ? 1 : 0;
        QCOMPARE(asked, got["r/low"].size() + got["r/high"].size());
        for (const std::string path : {"r/low", "r/high"}) {
            QVERIFY(got[path].size() > 10);
            QVERIFY(std::ranges::equal(got[path], std::span(all[path]).first(got[path].size())));
            QCOMPARE(end.waiting[path].size(), waits[path]);
        }
    }

    void packetsAreSentByTheRadioThatIsNamed() {
        OtherEnd end;
        for (const std::string radio : {"r/low", "r/high"}) {
            end.table.push_back({radio + "/pending", "output", {0}});
            end.table.push_back({radio + "/address", "output", {1}});
        }
        end.refuses = {"r/low"};
        RemoteRun run(kPost + "Robot r { Config=Post }\n", end);
        QVERIFY2(run.failure().empty(), run.failure().c_str());
        RemoteRadios radios(run.world());
        const std::vector<std::uint8_t> bytes = {7, 0, 255};
        QVERIFY(radios.send(radios.find("r/high").value(), bytes, 513, -12.5));
        QVERIFY(!radios.send(radios.find("r/low").value(), bytes, 514, 3));
        run.end();
        std::vector<Json> sends;
        for (const Json& each : end.requests)
            if (each["op"] == "send") sends.push_back({each["device"], each["to"], each["power"]});
        QCOMPARE(shown(sends), shown({{"r/high", 513, -12.5}, {"r/low", 514, 3.0}}));
        QCOMPARE(end.sent.at(0), std::string("\x07\x00\xff", 3));
    }

    /// Also a radio that the text has and the robot does not.
    void aRadioThatIsNotThereIsNotFound() {
        OtherEnd end;
        end.table = {{"r/high/pending", "output", {0}}, {"r/high/address", "output", {1}}};
        RemoteRun run(kPost + "Robot r { Config=Post }\n", end);
        QVERIFY2(run.failure().empty(), run.failure().c_str());
        RemoteRadios radios(run.world());
        QVERIFY(radios.find("r/high") && !radios.find("r/low"));
    }

    void atTheEndTheRobotRestsAndIsGivenBack_data() {
        QTest::addColumn<bool>("hasController");
        QTest::addColumn<bool>("hasCommands");
        QTest::newRow("of none") << false << true;
        QTest::newRow("of a controller") << true << true;
        QTest::newRow("without commands") << true << false;
    }
    void atTheEndTheRobotRestsAndIsGivenBack() {
        QFETCH(bool, hasController);
        QFETCH(bool, hasCommands);
        OtherEnd end;
        end.hasController = hasController;
        end.table = {{"r/lamp/lit", "output", {1}}, {"r/extra/speed", "command", {0.7}}}; // the text does not have that one
        if (hasCommands)
            end.table.insert(end.table.begin(), {{"r/lamp/on", "command", {0}}, {"r/lamp/color", "command", {0.2, 0.4, 0.6}}});
        else end.table.pop_back();
        RemoteRun run(kPost + "Robot r { Config=Post }\n", end);
        QVERIFY2(run.failure().empty(), run.failure().c_str());
        QVERIFY(run.tick()); // with nothing new
        run.set("r/lamp/on", 1);
        run.set("r/lamp/color", 0.9, 2);
        QVERIFY(run.tick() && run.tick());
        run.end();
        QStringList got,
            expected{"{'op':'hello','protocol':1,'token':'my-token'}", "{'op':'status'}", "{'op':'describe','robot':'r'}"};
        if (hasController) expected += "{'held':true,'op':'hold','robot':'r'}";
        expected += {"{'every':0,'op':'subscribe','signals':['r/*']}", "{'op':'read','subscription':5}"};
        const QString step = "{'op':'step','subscription':5,'ticks':1}";
        const QString commands =
            "{'op':'step','signals':{'r/lamp/color':[0.2,0.4,0.9],'r/lamp/on':1.0},'subscription':5,'ticks':1}";
        expected += {step, hasCommands ? commands : step, step}; // what has not changed is not sent again
        if (hasCommands)
            expected += "{'op':'command','signals':{'r/extra/speed':0.0,'r/lamp/color':[0.0,0.0,0.0],'r/lamp/on':0.0}}";
        if (hasController) expected += "{'held':false,'op':'hold','robot':'r'}";
        for (const Json& each : end.requests) {
            auto request = nlohmann::json::parse(each.dump()); // members in the order of the alphabet
            request.erase("id");
            got += QString::fromStdString(request.dump()).replace('"', '\'');
        }
        QCOMPARE(got, expected);
        for (const Signal& each : end.table)
            if (each.direction == "command") QCOMPARE(each.values, std::vector<double>(each.values.size()));
        QCOMPARE(end.table[hasCommands ? 2 : 0].values, std::vector{1.0}); // measured, not commanded
    }

    /// A robot that was never taken goes on as it does.
    void whatWasRefusedIsNotTouched() {
        OtherEnd end;
        end.hasController = true;
        end.state = "running";
        end.table = {{"r/lamp/on", "command", {1}}};
        {
            RemoteRun run(kPost + "Robot r { Config=Post }\n", end);
            QVERIFY2(run.failure().find("has to be paused") != std::string::npos, run.failure().c_str());
        }
        QCOMPARE(end.requests.size(), std::size_t(2));
        QCOMPARE(end.requests.back()["op"], Json("status"));
        QCOMPARE(end.table[0].values, std::vector{1.0});
    }
};

QTEST_APPLESS_MAIN(RemoteWorldTest)
#include "remote_world_test.moc"
