// Requests at their edges: indices of several robots and devices, limits, and what the reply says of the run.
#include <QTemporaryDir>
#include <QtTest>

#include <filesystem>
#include <fstream>
#include <numbers>

#include <trundle/abi.h>

#include "app/application.h"
#include "remote/peer.h"
#include "remote/server.h"

using namespace trundle;
using Json = nlohmann::json;

namespace {

const char* const kText =
    "Seed = 3  Tick = 0.02  Duration = 0.1\n#import robots/simple_robot.sim\n#import arenas/open_floor.sim\n"
    "Static floor { Config=OpenFloor }\nRobot r { Config=SimpleRobot }\n"
    "RobotConfig Post { Body hull { Box box { Size=0.2,0.2,0.1 Pos=0,0,0.05 Mass=1 } }\n"
    " Body other { Box box { Size=0.1,0.1,0.1 Pos=0,0,0.15 Mass=1 } } Fixed on { Parent=hull Child=other }\n"
    " Led lamp { Body=hull Pos=0,0,0.12 ColorRGB=0.25,0.5,0.75 On=false } Compass n { Body=hull UpdatePeriod=0.1 }\n"
    " Transceiver low { Body=hull Address=4 } Transceiver high { Body=hull Pos=0,0,0.3 Address=9 } }\n"
    "Robot p { Config=Post Pos=0,2,0 }\nRobot p2 { Config=Post Pos=3,2,0 }\n";
constexpr int kManyRounds = 200'000;

} // namespace

class RequestsTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;
    std::unique_ptr<Application> m_application = makeApplication();
    std::shared_ptr<const LoadedProject> m_loaded;
    std::vector<std::optional<std::uint64_t>> m_seeds;
    bool m_isBuildable = true;
    std::unique_ptr<ServedRun> m_run;
    std::unique_ptr<RemoteServer> m_server;

    Peer connect() {
        auto [ours, theirs] = std::move(Socket::pair().value());
        m_server->adopt(std::move(theirs));
        return {std::move(ours)};
    }
    std::pair<Json, std::string> answer(Peer& peer) {
        for (int i = 0; i < kManyRounds; ++i) {
            m_server->serve(std::chrono::milliseconds(0));
            if (auto message = peer.take()) return std::move(*message);
        }
        return {"no reply", {}};
    }
    std::pair<Json, std::string> ask(Peer& peer, const Json& request) {
        peer.ask(request);
        return answer(peer);
    }
    Json call(Peer& peer, const Json& request) { return ask(peer, request).first; }
    Json error(Peer& peer, const Json& request) { return call(peer, request).value("error", Json("none")); }
    static const Json& named(const Json& all, const char* key, const std::string& name) {
        static const Json kNone;
        for (const Json& each : all)
            if (each[key] == name) return each;
        return kNone;
    }

private Q_SLOTS:
    void initTestCase() {
        const std::string path = (std::filesystem::path(m_folder.path().toStdString()) / "main.sim").string();
        std::ofstream(path) << kText;
        m_loaded = m_application->open(path, {}).value();
        for (const Diagnostic& each : m_loaded->diagnostics.all())
            QVERIFY2(each.severity != Severity::Error, each.message.c_str());
    }
    void init() {
        m_isBuildable = true;
        m_run = std::make_unique<ServedRun>([this](std::optional<std::uint64_t> seed) {
            m_seeds.push_back(seed);
            ServedExperiment built;
            Diagnostics problems;
            built.sources = m_loaded->sources;
            if (m_isBuildable) built.runner = m_application->makeRunner(*m_loaded, {}, problems);
            return built;
        });
        QVERIFY(m_run->reset());
        m_server = std::make_unique<RemoteServer>(*m_run, ServerOptions{"0123456789abcdef", "main.sim", 2, {}});
        m_seeds.clear();
    }
    void cleanup() {
        m_server.reset();
        m_run.reset();
    }

    void signalsHaveTheirTypesAndDirections() {
        Peer peer = connect();
        const Json read = call(peer, {{"op", "read"}, {"signals", {"p/*"}}})["values"];
        QCOMPARE(read["p/lamp/lit"], Json(false));
        QVERIFY(read["p/lamp/on"].is_boolean());
        QCOMPARE(read["p/lamp/color"], Json({0.25, 0.5, 0.75}));
        QVERIFY(read["p/low/address"].is_number_integer() && read["p/low/address"] == 4 && read["p/high/address"] == 9);
        const Json described = call(peer, {{"op", "describe"}, {"robot", "p"}});
        for (const auto& [path, direction, type, count] : {std::tuple("p/lamp/color", "command", "real", 3),
                                                           {"p/lamp/lit", "output", "boolean", 1},
                                                           {"p/pose", "truth", "real", 7},
                                                           {"p/low/address", "output", "integer", 1}}) {
            const Json& signal = named(described["signals"], "path", path);
            QCOMPARE(signal["direction"], Json(direction));
            QCOMPARE(signal["type"], Json(type));
            QCOMPARE(signal["count"], Json(count));
        }
        QCOMPARE(named(described["devices"], "name", "n")["update_period"], Json(0.1));
        QCOMPARE(named(described["devices"], "name", "n")["interface"], Json("opaque"));
        QCOMPARE(named(described["devices"], "name", "low")["interface"], Json("wsn"));
        QCOMPARE(call(peer, {{"op", "read"}, {"device", "p2/high"}})["data"]["address"], Json(9));
    }

    void theHeldRobotIsShownAsHeld() {
        Peer peer = connect();
        QCOMPARE(call(peer, {{"op", "hold"}, {"robot", "p2"}})["ok"], Json(true));
        const Json robots = call(peer, {{"op", "list"}})["robots"];
        for (const std::string robot : {"r", "p", "p2"}) {
            QCOMPARE(named(robots, "robot", robot)["held"], Json(robot == "p2"));
            QCOMPARE(call(peer, {{"op", "describe"}, {"robot", robot}})["held"], Json(robot == "p2"));
        }
    }

    /// What is refused at one side of a limit is accepted at the other.
    void limits_data() {
        QTest::addColumn<QByteArray>("request");
        QTest::addColumn<QByteArray>("error");
        const auto row = [](const char* name, const Json& request, const char* error) {
            QTest::newRow(name) << QByteArray::fromStdString(request.dump()) << QByteArray(error);
        };
        const std::vector<std::string> most(64, "p/*"), more(65, "p/*");
        row("64 patterns to read", {{"op", "read"}, {"signals", most}}, "none");
        row("65 patterns to read", {{"op", "read"}, {"signals", more}}, "refused");
        row("64 patterns", {{"op", "subscribe"}, {"signals", most}}, "none");
        row("65 patterns", {{"op", "subscribe"}, {"signals", more}}, "refused");
        row("quickest", {{"op", "run"}, {"speed", 1000}}, "none");
        row("too quick", {{"op", "run"}, {"speed", 1000.5}}, "bad_request");
        row("largest seed", {{"op", "reset"}, {"seed", 1ull << 53}}, "none");
        row("larger seed", {{"op", "reset"}, {"seed", (1ull << 53) + 1}}, "bad_request");
        row("body of a body", {{"op", "push"}, {"body", "p/x/hull"}, {"force", {0, 0, 1}}, {"point", {0, 0, 0}}}, "no_such_path");
        row("device of a device", {{"op", "read"}, {"device", "p/x/lamp"}}, "no_such_path");
        row("four numbers of three", {{"op", "place"}, {"robot", "p"}, {"position", {0, 0, 1, 2}}}, "bad_request");
        row("step with what is not there", {{"op", "step"}, {"signals", {{"p/lamp/x", 1}}}}, "no_such_path");
        row("step with values of no subscription", {{"op", "step"}, {"subscription", 1}}, "no_such_path");
        row("true for a number", {{"op", "command"}, {"signals", {{"p/lamp/on", true}}}}, "none");
    }
    void limits() {
        QFETCH(QByteArray, request);
        QFETCH(QByteArray, error);
        Peer peer = connect();
        const Json reply = call(peer, Json::parse(request.toStdString()));
        QCOMPARE(QByteArray::fromStdString(reply.value("error", "none")), error);
        if (error != "none") QCOMPARE(call(peer, {{"op", "status"}})["tick"], Json(0));
    }

    void aLongUnknownMemberIsNamedAsFarAsItIsShort() {
        Peer peer = connect();
        const std::string name = "ticksOfTheRunThatIsServed";
        const Json refused = call(peer, {{"op", "step"}, {name, 1}});
        QVERIFY2(refused["message"].get<std::string>().starts_with("unknown member " + name), refused.dump().c_str());
    }

    void subscriptionsHaveTheirOwnValuesAndEnds() {
        Peer peer = connect();
        QCOMPARE(call(peer, {{"op", "subscribe"}, {"signals", {"p/lamp/lit"}}, {"every", 0}})["subscription"], Json(1));
        QCOMPARE(call(peer, {{"op", "subscribe"}, {"signals", {"p2/pose"}}, {"every", 3}})["subscription"], Json(2));
        const auto size = [&](int number) { return ask(peer, {{"op", "read"}, {"subscription", number}}).second.size(); };
        QCOMPARE(size(1), std::size_t(8));
        QCOMPARE(size(2), std::size_t(56));
        QCOMPARE(ask(peer, {{"op", "step"}, {"ticks", 7}, {"subscription", 2}}).second.size(), std::size_t(56));
        std::vector<Json> ticks;
        for (const auto& [event, bytes] : peer.events)
            if (event["event"] == "signals") ticks.push_back({event["subscription"], event["tick"]});
        QCOMPARE(Json(ticks).dump(), std::string("[[2,3],[2,6]]"));
        for (int i = 2; i < 64; ++i)
            QCOMPARE(error(peer, {{"op", "subscribe"}, {"signals", {"p/pose"}}, {"every", 0}}), Json("none"));
        QCOMPARE(error(peer, {{"op", "subscribe"}, {"signals", {"p/pose"}}}), Json("refused"));
        QCOMPARE(error(peer, {{"op", "unsubscribe"}, {"subscription", 1}}), Json("none"));
        QCOMPARE(error(peer, {{"op", "unsubscribe"}, {"subscription", 1}}), Json("no_such_path"));
        QCOMPARE(error(peer, {{"op", "read"}, {"subscription", 1}}), Json("no_such_path"));
        QCOMPARE(size(2), std::size_t(56));
        QCOMPARE(call(peer, {{"op", "reset"}})["ok"], Json(true));
        QCOMPARE(size(2), std::size_t(56)); // not twice
    }

    /// A turn to the left; of a push each vector in its place.
    void placesAndPushesAreInTheirAxes() {
        Peer peer = connect();
        QCOMPARE(error(peer, {{"op", "place"}, {"robot", "p2"}, {"position", {5, -1, 0.25}}, {"heading", std::numbers::pi / 2}}),
                 Json("none"));
        QCOMPARE(error(peer, {{"op", "push"}, {"body", "p2/other"}, {"force", {1, 2, 3}}, {"point", {4, 5, 6}}}), Json("none"));
        QCOMPARE(error(peer, {{"op", "step"}}), Json("none"));
        QCOMPARE(m_run->runner().commands().size(), std::size_t(2));
        for (const Command& each : m_run->runner().commands()) {
            if (const auto* push = std::get_if<PushCommand>(&each.what)) {
                QCOMPARE(push->body, std::string("p2/other"));
                QVERIFY(push->force == Vec3(1, 2, 3) && push->point == Vec3(4, 5, 6));
                continue;
            }
            const auto& place = std::get<PlaceCommand>(each.what);
            QCOMPARE(place.robot, std::string("p2"));
            QVERIFY(place.pose.position == Vec3(5, -1, 0.25));
            QVERIFY((place.pose.rotation * Vec3::UnitX() - Vec3::UnitY()).norm() < 1e-12);
        }
    }

    /// Each number of a command of several, in its place.
    void numbersOfACommand() {
        Peer peer = connect();
        QCOMPARE(error(peer, {{"op", "command"}, {"signals", {{"p2/lamp/color", {0.125, 0.25, 0.375}}}}}), Json("none"));
        QCOMPARE(error(peer, {{"op", "step"}}), Json("none"));
        const Json read = call(peer, {{"op", "read"}, {"signals", {"p*/lamp/color"}}})["values"];
        QCOMPARE(read["p2/lamp/color"], Json({0.125, 0.25, 0.375}));
        QCOMPARE(read["p/lamp/color"], Json({0.25, 0.5, 0.75}));
    }

    void radioPacketsHaveTheirFigures() {
        Peer peer = connect();
        std::string frame;
        appendFrame(frame, Json{{"id", 1}, {"op", "send"}, {"device", "p/low"}, {"power", -20}}.dump(),
                    std::string("\x07\x00\xff", 3));
        peer.write(frame);
        QCOMPARE(answer(peer).first["ok"], Json(true));
        QCOMPARE(call(peer, {{"op", "step"}, {"ticks", 3}})["ok"], Json(true));
        const auto [weak, bytes] = ask(peer, {{"op", "receive"}, {"device", "p2/high"}});
        QCOMPARE(bytes, std::string("\x07\x00\xff", 3)); // to all, as no other address is given
        QCOMPARE(std::tuple(weak["from"], weak["to"], weak["sequence"]), std::tuple(Json(4), Json(65535), Json(0)));
        QVERIFY2(weak["rssi"] < -40 && weak["lqi"] >= 0, weak.dump().c_str());
        peer.ask({{"op", "send"}, {"device", "p/low"}});
        QCOMPARE(answer(peer).first["ok"], Json(true));
        QCOMPARE(call(peer, {{"op", "step"}, {"ticks", 3}})["ok"], Json(true));
        const Json strong = call(peer, {{"op", "receive"}, {"device", "p2/high"}});
        QVERIFY2(strong["rssi"] > weak["rssi"], strong.dump().c_str());
        QCOMPARE(call(peer, {{"op", "receive"}, {"device", "p2/high"}})["received"], Json(false));
    }

    void theStatusIsThatOfTheRun() {
        Peer peer = connect();
        const Json start = call(peer, {{"op", "status"}});
        QCOMPARE(std::tuple(start["tick_s"], start["duration_s"], start["seed"], start["state"]),
                 std::tuple(Json(0.02), Json(0.1), Json(3), Json("paused")));
        QCOMPARE(call(peer, {{"op", "run"}, {"speed", 0}})["state"], Json("running"));
        for (int i = 0; i < kManyRounds && m_run->state() == ServedState::Running; ++i) m_server->serve({});
        const Json stopped = call(peer, {{"op", "status"}});
        QCOMPARE(std::tuple(stopped["tick"], stopped["time"], stopped["speed"]), std::tuple(Json(5), Json(0.1), Json(0.)));
        QCOMPARE(stopped["reason"], Json("the Duration of the text is reached"));
        QCOMPARE(error(peer, {{"op", "push"}, {"body", "p/hull"}, {"force", {0, 0, 9e8}}, {"point", {0, 0, 0}}}), Json("none"));
        QCOMPARE(call(peer, {{"op", "step"}, {"ticks", 3}})["tick"], Json(8));
        const Json ended = call(peer, {{"op", "status"}})["ended"];
        QCOMPARE(ended.size(), std::size_t(1));
        QCOMPARE(ended[0]["robot"], Json("p"));
        const double ticks = ended[0]["time"].get<double>() / 0.02;
        QVERIFY(ticks > 5 && std::abs(ticks - std::round(ticks)) < 1e-12);
    }

    void aResetWithASeedAndOneThatFails() {
        Peer peer = connect(), other = connect();
        QCOMPARE(error(peer, {{"op", "reset"}, {"seed", 41}}), Json("none"));
        QCOMPARE(error(peer, {{"op", "reset"}}), Json("none"));
        QCOMPARE(m_seeds, (std::vector<std::optional<std::uint64_t>>{41, std::nullopt}));
        other.ask({{"id", 7}, {"op", "step"}, {"ticks", 1'000'000'000}}); // ends with the run that it is of
        for (int i = 0; i < 50; ++i) m_server->serve({});
        QCOMPARE(error(peer, {{"op", "reset"}}), Json("none"));
        const Json old = answer(other).first;
        QVERIFY2(old["id"] == 7 && old["tick"] == 0 && old["ticks"] < 1000, old.dump().c_str());
        other.ask({{"id", 8}, {"op", "step"}, {"ticks", 1'000'000'000}});
        for (int i = 0; i < 50; ++i) m_server->serve({});
        m_isBuildable = false;
        QCOMPARE(error(peer, {{"op", "reset"}}), Json("failed"));
        const Json cut = answer(other).first;
        QCOMPARE(cut["id"], Json(8));
        m_server->serve({});
        QVERIFY(!other.take()); // events alone
        QCOMPARE(other.events.back().first["event"], Json("state"));
        QCOMPARE(std::ranges::count_if(other.events, [](const auto& each) { return each.first["event"] == "reset"; }), 4);
        for (const auto& [operation, expected] :
             {std::pair("read", "ended"), {"step", "ended"}, {"status", "none"}, {"console", "none"}})
            QCOMPARE(error(peer, {{"op", operation}}), Json(expected));
        m_isBuildable = true;
        QCOMPARE(error(peer, {{"op", "reset"}}), Json("none"));
        QCOMPARE(call(other, {{"op", "step"}})["tick"], Json(1));
    }

    void linesGoToThoseWhoWantThem() {
        Peer peer = connect(), deaf = connect();
        QCOMPARE(error(deaf, {{"op", "console"}, {"on", false}}), Json("none"));
        for (const int severity : std::vector<int>{TRUNDLE_INFO, TRUNDLE_WARNING, TRUNDLE_ERROR, 99})
            m_server->addLine(0.5, "p", severity, "text");
        for (Peer* each : {&peer, &deaf}) QCOMPARE(error(*each, {{"op", "status"}}), Json("none"));
        QStringList got;
        for (const auto& [event, bytes] : peer.events) got += QString::fromStdString(event["severity"].get<std::string>());
        QCOMPARE(got, (QStringList{"info", "warning", "error", "error"}));
        QVERIFY(deaf.events.empty());
        QCOMPARE(error(deaf, {{"op", "console"}}), Json("none")); // on, if nothing else is said
        m_server->addLine(0.5, "p", TRUNDLE_INFO, "text");
        QCOMPARE(error(deaf, {{"op", "status"}}), Json("none"));
        QCOMPARE(deaf.events.size(), std::size_t(1));
        QVERIFY(!deaf.events[0].first.contains("dropped"));
    }

    /// Whole numbers and short texts are repeated, other ids are not.
    void idsAreRepeated() {
        Peer peer = connect();
        const std::string longest(64, 'x');
        for (const auto& [given, expected] : std::vector<std::pair<Json, Json>>{
                 {-7, -7}, {"", ""}, {longest, longest}, {longest + "x", nullptr}, {1.5, nullptr}, {true, nullptr}})
            QCOMPARE(call(peer, {{"id", given}, {"op", "status"}})["id"], expected);
    }

    /// Each client gets its turn, also while another asks for step after step.
    void stepsTakeTurns() {
        Peer first = connect(), second = connect();
        first.ask({{"id", 1}, {"op", "step"}});
        first.ask({{"id", 2}, {"op", "step"}});
        second.ask({{"id", 3}, {"op", "step"}, {"ticks", 2}});
        QCOMPARE(answer(first).first["tick"], Json(1));
        QCOMPARE(answer(second).first["tick"], Json(3));
        QCOMPARE(answer(first).first["tick"], Json(4));
        QCOMPARE(call(first, {{"op", "step"}, {"ticks", 0}})["tick"], Json(4));
    }

    void whoIsAdoptedEndsTheServer() {
        Peer peer = connect();
        {
            Peer other = connect();
            QCOMPARE(error(other, {{"op", "status"}}), Json("none"));
            m_server->close();
            for (int i = 0; i < 5; ++i) m_server->serve({});
            QVERIFY(!other.take());
            QCOMPARE(other.events.back().first["event"], Json("state"));
            QCOMPARE(other.events.back().first["state"], Json("ended"));
        }
    }
};

QTEST_APPLESS_MAIN(RequestsTest)
#include "requests_test.moc"
