// The server with clients that are slow, broken or gone, in one thread: serve() is called until what a test waits for has happened.
#include <QTemporaryDir>
#include <QtTest>

#include <filesystem>
#include <fstream>

#include "app/application.h"
#include "remote/peer.h"
#include "remote/server.h"
#include "run/experiment_runner.h"
#include "run/fake_world.h"
#include "run/scripted_backend.h"

using namespace trundle;
using Json = nlohmann::json;

namespace {

constexpr int kManyRounds = 200'000;

const char* const kText =
    "Seed = 3\n#import robots/simple_robot.sim\n#import arenas/open_floor.sim\n"
    "Static floor { Config=OpenFloor }\nRobot r { Config=SimpleRobot }\n"
    "Robot r2 { Config=SimpleRobot Pos=0,1,0 }\n"
    "RobotConfig C { Body b { Sphere s { Radius=0.1 Mass=1 } }\n  Compass n { Body=b } Compass n2 { Body=b }\n"
    "  Led nn { Body=b } }\nRobot c { Config=C Pos=3,0,0.1 }\n";

} // namespace

class ServerTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    std::unique_ptr<Application> m_application = makeApplication();
    std::shared_ptr<const LoadedProject> m_loaded;
    std::unique_ptr<ServedRun> m_run;
    std::unique_ptr<RemoteServer> m_server;

    Peer connect() {
        auto [ours, theirs] = std::move(Socket::pair().value());
        m_server->adopt(std::move(theirs));
        return {std::move(ours), FrameReader({1u << 26, 1u << 26}), {}};
    }
    Json reply(Peer& peer) {
        for (int i = 0; i < kManyRounds; ++i) {
            m_server->serve(std::chrono::milliseconds(0));
            if (auto message = peer.take()) return message->first;
        }
        return "no reply";
    }
    Json call(Peer& peer, const Json& request) {
        peer.ask(request);
        return reply(peer);
    }
    void serve(int rounds) {
        for (int i = 0; i < rounds; ++i) m_server->serve(std::chrono::milliseconds(0));
    }

private Q_SLOTS:
    void initTestCase() {
        const std::string path = (std::filesystem::path(m_folder.path().toStdString()) / "main.sim").string();
        std::ofstream(path) << kText;
        m_loaded = m_application->open(path, {}).value();
        QVERIFY(!m_loaded->diagnostics.hasErrors());
    }
    void init() {
        m_run = std::make_unique<ServedRun>([this](std::optional<std::uint64_t>) {
            ServedExperiment built;
            Diagnostics problems;
            built.sources = m_loaded->sources;
            built.runner = m_application->makeRunner(*m_loaded, {}, problems);
            return built;
        });
        QVERIFY(m_run->reset());
        ServerOptions options;
        options.token = "0123456789abcdef";
        m_server = std::make_unique<RemoteServer>(*m_run, options);
    }
    void cleanup() {
        m_server.reset();
        m_run.reset();
    }

    void aSlowReaderLosesEventsAndNothingElse() {
        Peer slow = connect(), quick = connect();
        QCOMPARE(call(slow, {{"id", 1}, {"op", "subscribe"}, {"signals", {"*"}}})["ok"], Json(true));
        slow.ask({{"id", 2}, {"op", "hash"}}); // is answered, however late
        const Json stepped = call(quick, {{"id", "s"}, {"op", "step"}, {"ticks", 5000}});
        QCOMPARE(stepped["ticks"], Json(5000));
        QCOMPARE(m_run->world().ticks(), std::uint64_t(5000));
        QCOMPARE(reply(slow)["id"], Json(2));
        const auto last = [&] { return slow.events.empty() ? 0 : slow.events.back().first["tick"].get<int>(); };
        for (int i = 0; i < kManyRounds && last() < 5000; ++i) {
            serve(1);
            QVERIFY(!slow.take());
        }
        (void)call(quick, {{"id", 3}, {"op", "step"}});
        serve(1);
        QVERIFY(!slow.take());
        const std::size_t got = slow.events.size();
        QVERIFY2(got > 10 && got < 5000, QByteArray::number(qulonglong(got)));
        std::uint64_t skipped = 0, tick = 0;
        for (const auto& [event, bytes] : slow.events) {
            const std::uint64_t left = event.value("skipped", 0ull);
            QCOMPARE(event["tick"].get<std::uint64_t>(), tick + left + 1); // each event says how many are missing before it
            tick = event["tick"];
            skipped += left;
            QCOMPARE(bytes.size(), std::size_t(8) * m_run->world().layout().slotCount());
        }
        QCOMPARE(tick, std::uint64_t(5001));
        QCOMPARE(skipped + got, std::uint64_t(5001));
    }

    void requestsWithoutReadingRepliesWait() {
        Peer greedy = connect(), other = connect();
        std::string request;
        appendFrame(request, R"({"id":7,"op":"describe","robot":"r"})");
        std::size_t asked = 0, part = 0; // until neither end takes more
        for (int idle = 0; idle < 100;) {
            const std::size_t sent = greedy.socket.write(std::string_view(request).substr(part)).value_or(0);
            idle = sent == 0 ? idle + 1 : 0;
            part += sent;
            if (part == request.size()) ++asked, part = 0;
            serve(1);
        }
        QVERIFY2(asked > 200, QByteArray::number(qulonglong(asked)));
        QCOMPARE(call(other, {{"id", 1}, {"op", "step"}, {"ticks", 3}})["tick"], Json(3));
        std::size_t answered = 0;
        for (int idle = 0; idle < 100;) {
            serve(1);
            const auto message = greedy.take();
            idle = message ? 0 : idle + 1;
            if (!message) continue;
            QCOMPARE(message->first["id"], Json(7));
            ++answered;
        }
        QCOMPARE(answered, asked); // none is lost
    }

    /// Not those of a robot whose name begins with its own.
    void aRobotIsDescribedByItsSignals() {
        Peer peer = connect();
        const SignalLayout& layout = m_run->world().layout();
        for (const std::string robot : {"r", "r2"}) {
            const Json described = call(peer, {{"id", 1}, {"op", "describe"}, {"robot", robot}});
            std::vector<std::string> paths, expected;
            for (const Json& each : described["signals"]) paths.push_back(each["path"]);
            for (const SignalEntry& entry : layout.entries())
                if (entry.path.substr(0, entry.path.find('/')) == robot) expected.push_back(entry.path);
            QVERIFY(!expected.empty());
            QCOMPARE(paths, expected);
        }
    }

    /// Of a kind without an interface: its own outputs, not those of a device whose name begins with its own.
    void aDeviceIsReadByItsOutputs() {
        Peer peer = connect();
        for (const std::string device : {"c/n", "c/n2", "c/nn"}) {
            const Json read = call(peer, {{"op", "read"}, {"device", device}});
            std::set<std::string> names, expected;
            for (const auto& [name, value] : read["data"].items()) names.insert(name);
            for (const SignalEntry& e : m_run->world().layout().entries())
                if (e.path.substr(0, e.path.rfind('/')) == device && e.direction == SignalDirection::Output)
                    expected.insert(e.path.substr(device.size() + 1));
            QVERIFY(!expected.empty() && names == expected);
        }
    }

    void aClientMayGoAtAnyByte() {
        Peer other = connect();
        std::string bytes;
        appendFrame(bytes, R"({"id":1,"op":"step","ticks":1000000000})", "payload");
        for (std::size_t cut = 0; cut <= bytes.size(); ++cut) {
            {
                Peer gone = connect();
                gone.write(std::string_view(bytes).substr(0, cut));
                serve(3);
            }
            for (int i = 0; i < kManyRounds && m_server->clientCount() > 1; ++i) serve(1);
            QCOMPARE(m_server->clientCount(), std::size_t(1));
        }
        const std::uint64_t ticks = m_run->world().ticks();
        serve(100);
        QCOMPARE(m_run->world().ticks(), ticks); // the step of the last one has ended with it
        QCOMPARE(call(other, {{"id", 1}, {"op", "status"}})["tick"].get<std::uint64_t>(), ticks);
    }

    void mistakesAreAnsweredAndTheNextRequestWorks_data() {
        QTest::addColumn<QByteArray>("request");
        QTest::addColumn<QByteArray>("error");
        QTest::addColumn<QByteArray>("message");
        const auto row = [](const char* name, const char* request, const char* error, const char* message) {
            QTest::newRow(name) << QByteArray(request) << QByteArray(error) << QByteArray(message);
        };
        row("no JSON", "{", "bad_request", "a request must be a JSON object");
        row("no object", "[1]", "bad_request", "a request must be a JSON object");
        row("no UTF-8", "{\"op\":\"\xff\"}", "bad_request", "a request must be a JSON object");
        row("operation", R"({"op":"stepp"})", "unknown_operation", "unknown operation stepp; did you mean step?");
        row("member", R"({"op":"step","tick":3})", "bad_request", "unknown member tick; did you mean ticks?");
        row("ticks", R"({"op":"step","ticks":-3})", "bad_request", "ticks must be a whole number from 0 to 1000000000");
        row("robot", R"({"op":"describe","robot":"x"})", "no_such_path", "there is no robot x");
        row("signal", R"({"op":"command","signals":{"r/base/linearVelocty":1}})", "no_such_path",
            "there is no signal r/base/linearVelocty; did you mean r/base/linearVelocity?");
        row("output", R"({"op":"command","signals":{"r/leftEncoder/count":1}})", "refused", "r/leftEncoder/count is measured, not commanded");
        row("value", R"({"op":"command","signals":{"r/base/linearVelocity":null}})", "bad_request",
            "the value of r/base/linearVelocity must be a finite number, or an array of them");
        row("values", R"({"op":"command","signals":{"r/base/linearVelocity":[0.1,"x"]}})", "bad_request",
            "the value of r/base/linearVelocity must be a finite number, or an array of them");
        row("count", R"({"op":"command","signals":{"r/base/linearVelocity":[0.1,0.2]}})", "refused",
            "r/base/linearVelocity has 1 number, not 2");
        row("interface", R"({"op":"command","device":"r/base","vel":[1]})", "bad_request", "vel must be an array of 2 finite numbers");
        row("no command", R"({"op":"command","device":"r/base"})", "bad_request",
            "a position2d of kind DifferentialDrive needs one of: vel");
        row("sensor", R"({"op":"command","device":"r/frontTouch"})", "bad_request",
            "a bumper of kind TouchSensor has no commands of its interface; set its signals instead");
        row("camera", R"({"op":"image","camera":"r/base"})", "no_such_path", "there is no camera r/base");
        row("nothing", R"({"op":"subscribe","signals":["q*"]})", "no_such_path", "no signal matches q*; `describe` lists those of a robot");
        row("speed", R"({"op":"run","speed":-1})", "bad_request", "speed must be from 0, which is as fast as possible, to 1000");
        row("controller", R"({"op":"restart","robot":"r"})", "no_such_path", "there is no robot r with a controller");
    }
    void mistakesAreAnsweredAndTheNextRequestWorks() {
        QFETCH(QByteArray, request);
        QFETCH(QByteArray, error);
        QFETCH(QByteArray, message);
        Peer peer = connect();
        std::string bytes;
        appendFrame(bytes, request.toStdString());
        peer.write(bytes);
        const Json refused = reply(peer);
        QCOMPARE(refused["ok"], Json(false));
        QCOMPARE(QByteArray::fromStdString(refused["error"].get<std::string>()), error);
        QCOMPARE(QByteArray::fromStdString(refused["message"].get<std::string>()), message);
        QCOMPARE(call(peer, {{"id", 9}, {"op", "step"}})["tick"], Json(1));
    }

    void whoHasGoneTakesNoSeat() {
        Socket listener = Socket::listen("127.0.0.1", 0).value();
        const std::uint16_t port = listener.port();
        m_server->listen(std::move(listener));
        const auto connected = [port] { return Socket::connect("127.0.0.1", port).value(); };
        {
            std::vector<Socket> going;
            for (int i = 0; i < 14; ++i) going.push_back(connected());
            serve(1); // these have seats, of the next ten two get one
            for (int i = 0; i < 10; ++i) going.push_back(connected());
        }
        Peer last{connected(), FrameReader({1u << 26, 1u << 26}), {}};
        QCOMPARE(call(last, {{"id", 1}, {"op", "hello"}, {"token", "0123456789abcdef"}})["ok"], Json(true));
    }
    void afterAFrameThatIsTooLargeTheConnectionIsClosed() {
        Peer peer = connect();
        peer.write(std::string(100, 'x'));
        const Json refused = reply(peer);
        QCOMPARE(refused["error"], Json("bad_frame"));
        serve(2);
        QCOMPARE(m_server->clientCount(), std::size_t(0));
        char byte;
        QVERIFY(!peer.socket.read(std::span(&byte, 1)).has_value());
    }

    void stepsOfTwoClientsFollowEachOther() {
        Peer first = connect(), second = connect();
        first.ask({{"id", 1}, {"op", "step"}, {"ticks", 300}});
        second.ask({{"id", 2}, {"op", "step"}, {"ticks", 5}});
        const Json one = reply(first), two = reply(second);
        QCOMPARE(one["tick"], Json(300));
        QCOMPARE(two["tick"], Json(305));
    }

    void aPauseEndsOnesOwnStep() {
        Peer peer = connect();
        peer.ask({{"id", 1}, {"op", "step"}, {"ticks", 1'000'000'000}});
        serve(50);
        peer.ask({{"id", 2}, {"op", "pause"}});
        peer.ask({{"id", 3}, {"op", "step"}, {"ticks", 2}});
        const Json cut = reply(peer), paused = reply(peer), stepped = reply(peer);
        QCOMPARE(std::tuple(cut["id"], paused["id"], stepped["id"]), std::tuple(Json(1), Json(2), Json(3)));
        QVERIFY(cut["ticks"].get<int>() > 0 && cut["ticks"].get<int>() < 1'000'000);
        QCOMPARE(paused["tick"], cut["tick"]);
        QCOMPARE(stepped["tick"].get<int>(), cut["tick"].get<int>() + 2);
    }

    void runningEndsStepsAndRefusesNewOnes() {
        Peer first = connect(), second = connect();
        first.ask({{"id", 1}, {"op", "step"}, {"ticks", 1'000'000'000}});
        serve(50);
        QCOMPARE(call(second, {{"id", 2}, {"op", "run"}, {"speed", 0}})["state"], Json("running"));
        const Json cut = reply(first);
        QVERIFY(cut["ticks"].get<int>() > 0 && cut["ticks"].get<int>() < 1'000'000);
        QCOMPARE(call(first, {{"id", 3}, {"op", "step"}})["error"], Json("busy"));
        const std::uint64_t tick = m_run->world().ticks();
        serve(100);
        QVERIFY(m_run->world().ticks() > tick);
        QCOMPARE(call(first, {{"id", 4}, {"op", "pause"}})["state"], Json("paused"));
        QVERIFY(call(first, {{"id", 5}, {"op", "step"}})["ok"].get<bool>());
    }

    void aResetStartsAgainAndKeepsSubscriptions() {
        Peer peer = connect(), other = connect();
        const Json start = call(peer, {{"op", "hash"}});
        QCOMPARE(call(peer, {{"op", "subscribe"}, {"signals", {"r/base/*"}}})["subscription"], Json(1));
        QCOMPARE(call(peer, {{"op", "command"}, {"device", "r/base"}, {"vel", {0.2, 0.1}}})["ok"], Json(true));
        QCOMPARE(call(peer, {{"op", "step"}, {"ticks", 100}})["tick"], Json(100));
        const Json driven = call(peer, {{"op", "hash"}});
        QVERIFY(driven["hash"] != start["hash"]);
        QCOMPARE(call(peer, {{"op", "reset"}})["tick"], Json(0));
        QCOMPARE(call(peer, {{"op", "hash"}})["hash"], start["hash"]);
        serve(1);
        QVERIFY(!other.take());
        QCOMPARE(other.events.back().first["event"], Json("reset"));
        QCOMPARE(call(peer, {{"op", "command"}, {"signals", {{"r/base/linearVelocity", 0.2}, {"r/base/angularVelocity", 0.1}}}})["ok"], Json(true));
        peer.events.clear();
        QCOMPARE(call(peer, {{"op", "step"}, {"ticks", 100}})["tick"], Json(100));
        QCOMPARE(call(peer, {{"op", "hash"}})["hash"], driven["hash"]);
        QCOMPARE(peer.events.size(), std::size_t(100));
        const Json read = call(peer, {{"op", "read"}, {"device", "r/base"}});
        QCOMPARE(read["interface"], Json("position2d"));
        QVERIFY(read["data"]["pos"][0].get<double>() > 0.1);
    }

    void whatIsHeldToTheWorldIsNotPlaced() {
        const std::string path = (std::filesystem::path(m_folder.path().toStdString()) / "held.sim").string();
        std::ofstream(path) << kText << "Fixed hold { Parent=world Child=r2.chassis }\n";
        const std::shared_ptr<const LoadedProject> others = std::exchange(m_loaded, m_application->open(path, {}).value());
        QVERIFY(m_run->reset());
        Peer peer = connect();
        QCOMPARE(call(peer, {{"op", "place"}, {"robot", "r"}, {"position", {1, 0, 0}}})["ok"], Json(true));
        const Json refused = call(peer, {{"op", "place"}, {"robot", "r2"}, {"position", {1, 0, 0}}});
        QVERIFY2(refused.dump().find("r2 cannot be placed: hold holds r2 to the world") != std::string::npos,
                 refused.dump().c_str());
        cleanup();
        m_loaded = others;
    }

    /// A request that the run would refuse in the coming tick is refused at once, and a robot that has ended is in the status.
    void whatTheRunWouldRefuseIsRefusedAtOnce() {
        Peer peer = connect();
        const auto place = [&](double x) -> Json {
            return call(peer, {{"op", "place"}, {"robot", "r"}, {"position", {x, 0, 0}}});
        };
        const auto push = [&](double force) -> Json {
            return call(peer, {{"op", "push"}, {"body", "r/chassis"}, {"force", {0, 0, force}}, {"point", {0, 0, 0.1}}});
        };
        QCOMPARE(place(1e9)["message"], Json("a robot's position must be finite and within 100 km"));
        QCOMPARE(push(2e9)["message"], Json("a push needs a finite force of at most 1e9 N"));
        QCOMPARE(call(peer, {{"op", "status"}})["ended"], Json::array());
        QCOMPARE(push(9e8)["ok"], Json(true));
        QCOMPARE(call(peer, {{"op", "step"}, {"ticks", 3}})["tick"], Json(3)); // the other robot continues
        const Json ended = call(peer, {{"op", "status"}})["ended"];
        QCOMPARE(ended.size(), std::size_t(1));
        QCOMPARE(ended[0]["robot"], Json("r"));
        QVERIFY2(ended[0]["body"].is_string() && ended[0]["time"].is_number() && ended[0]["reason"].is_string(),
                 ended.dump().c_str());
        for (const Json& refused : {place(0), push(1)}) {
            QCOMPARE(refused["error"], Json("refused"));
            QCOMPARE(refused["message"], Json("r has ended and stays where it is until the run starts again"));
        }
    }

    /// Also those on one body and of several clients, in the order in which they came, once each.
    void allPushesOfATickAct() {
        Peer one = connect(), other = connect();
        std::vector<double> forces, acted;
        for (int i = 0; i < 12; ++i) {
            forces.push_back(i % 2 == 0 ? 1 + i : -1 - i);
            const Json push{
                {"op", "push"}, {"body", "r/chassis"}, {"force", {0, forces.back(), 0}}, {"point", {0.01 * i, 0, 0.05}}};
            QCOMPARE(call(i % 3 == 0 ? other : one, push)["ok"], Json(true));
        }
        QCOMPARE(call(one, {{"op", "step"}, {"ticks", 2}})["ok"], Json(true));
        for (const Command& each : m_run->runner().commands())
            if (const auto* push = std::get_if<PushCommand>(&each.what); push && each.tick == 0) acted.push_back(push->force.y());
        QCOMPARE(acted, forces);
        QCOMPARE(m_run->runner().commands().size(), forces.size());
    }

    /// The commands are those of the controllers that the robot has now, not at the start of the run.
    void aSwapChangesWhoOwnsTheCommands() {
        std::string story;
        std::vector<double> gaps;
        ExperimentRunner runner(std::make_unique<FakeWorld>(experimentOf({"r"})), {});
        Diagnostics diagnostics;
        runner.startControllers(
            [&](const ControllerRequest&) -> Result<std::unique_ptr<ControllerBackend>> {
                auto backend = std::make_unique<ScriptedBackend>();
                backend->story = &story;
                backend->gaps = &gaps;
                return std::unique_ptr<ControllerBackend>(std::move(backend));
            },
            diagnostics);
        ServedRun run(runner);
        m_server = std::make_unique<RemoteServer>(run, ServerOptions());
        Peer peer = connect();
        const Json set{{"op", "command"}, {"signals", {{"r/base/linearVelocity", 0.2}}}};
        const Json restart{{"op", "restart"}, {"robot", "r"}};
        const auto controllers = [&] { return call(peer, {{"op", "list"}})["robots"][0]["controllers"].dump(); };
        QCOMPARE(call(peer, set)["ok"], Json(true));
        QCOMPARE(call(peer, restart)["error"], Json("no_such_path"));
        QCOMPARE(controllers(), std::string("[]"));
        const ControllerSpec brain{{"Scripted", "brain", {{"UpdatePeriod", numberValue(0)}}, {}, {}}, {}};
        runner.command(SwapCommand{"r", "", brain, "scripted.so"});
        QVERIFY(runner.tick().ok());
        QCOMPARE(call(peer, set)["error"], Json("owned"));
        QCOMPARE(call(peer, restart)["ok"], Json(true));
        QCOMPARE(controllers(), std::string(R"([{"kind":"Scripted","name":"brain"}])"));
        QCOMPARE(call(peer, {{"op", "describe"}, {"robot", "r"}})["controller"]["name"], Json("brain"));
        runner.command(SwapCommand{"r", "brain", {}, {}});
        QVERIFY(runner.tick().ok());
        QCOMPARE(call(peer, set)["ok"], Json(true));
        QCOMPARE(controllers(), std::string("[]"));
        m_server.reset();
    }

    /// A command that is refused as a whole leaves none of its values behind.
    void aRefusedCommandHasNoEffect() {
        Peer peer = connect();
        QCOMPARE(call(peer, {{"op", "command"}, {"signals", {{"r/base/linearVelocity", 0.2}, {"r/base/x", 0.1}}}})["ok"], Json(false));
        QCOMPARE(call(peer, {{"op", "step"}, {"ticks", 10}})["ok"], Json(true));
        QCOMPARE(call(peer, {{"op", "read"}, {"signals", {"r/base/linearVelocity"}}})["values"]["r/base/linearVelocity"], Json(0.0));
    }
};

QTEST_APPLESS_MAIN(ServerTest)
#include "server_test.moc"
