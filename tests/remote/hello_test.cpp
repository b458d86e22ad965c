// Who may use the server: tokens, seats, and the run of a window that is served by the way.
#include <QtTest>

#include "remote/peer.h"
#include "remote/run_guest.h"
#include "remote/server.h"
#include "run/experiment_runner.h"
#include "run/fake_world.h"

using namespace trundle;
using Json = nlohmann::json;

namespace {

constexpr int kManyRounds = 2'000'000;
const std::string kToken = "0123456789abcdef";

struct Guests {
    explicit Guests(ServerOptions options = {}) {
        options.token = kToken;
        server = std::make_unique<RemoteServer>(run, options);
        Socket listener = Socket::listen("127.0.0.1", 0).value();
        port = listener.port();
        server->listen(std::move(listener));
    }
    Peer connect() const { return {Socket::connect("127.0.0.1", port).value()}; }
    Json reply(Peer& peer) const {
        for (int i = 0; i < kManyRounds; ++i) {
            server->serve(std::chrono::milliseconds(0));
            if (auto message = peer.take()) return message->first;
        }
        return "no reply";
    }
    Json call(Peer& peer, const Json& request) const {
        peer.ask(request);
        return reply(peer);
    }
    bool isClosed(Peer& peer) const {
        for (int i = 0; i < 3; ++i) server->serve({});
        char byte;
        return server->clientCount() == 0 && !peer.socket.read(std::span(&byte, 1)).has_value();
    }

    ExperimentRunner runner{std::make_unique<FakeWorld>(experimentOf({"a", "a2"})), RunOptions()};
    ServedRun run{runner};
    std::unique_ptr<RemoteServer> server;
    std::uint16_t port = 0;
};

} // namespace

class HelloTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void onlyTheTokenOpens_data() {
        QTest::addColumn<QByteArray>("request");
        QTest::addColumn<QByteArray>("error");
        const auto row = [](const char* name, const Json& request, const char* error) {
            QTest::newRow(name) << QByteArray::fromStdString(request.dump()) << QByteArray(error);
        };
        const auto hello = [](const std::string& token) { return Json{{"op", "hello"}, {"token", token}}; };
        row("right", hello(kToken), "none");
        row("none", {{"op", "hello"}}, "unauthorized");
        row("short", hello(kToken.substr(0, 15)), "unauthorized");
        row("long", hello(kToken + "0"), "unauthorized");
        row("last", hello("0123456789abcdee"), "unauthorized");
        row("first", hello("1123456789abcdef"), "unauthorized");
        row("no hello", {{"op", "status"}}, "unauthorized");
        row("no hello, with a token", {{"op", "status"}, {"token", kToken}}, "unauthorized");
        row("older protocol", {{"op", "hello"}, {"token", kToken}, {"protocol", 0}}, "refused");
        row("newer protocol", {{"op", "hello"}, {"token", kToken}, {"protocol", 2}}, "refused");
        row("this protocol", {{"op", "hello"}, {"token", kToken}, {"protocol", 1}}, "none");
        row("no object", Json::array(), "bad_request");
    }
    void onlyTheTokenOpens() {
        QFETCH(QByteArray, request);
        QFETCH(QByteArray, error);
        Guests guests;
        Peer peer = guests.connect();
        const Json reply = guests.call(peer, Json::parse(request.toStdString()));
        QCOMPARE(QByteArray::fromStdString(reply.value("error", "none")), error);
        if (error != "none") {
            QVERIFY(guests.isClosed(peer));
            return;
        }
        // More than before: a request of more than 4 KiB, and other operations.
        QCOMPARE(guests.call(peer, {{"op", "status"}, {"id", std::string(60, 'x')}})["ok"], Json(true));
        QCOMPARE(guests.call(peer, {{"op", "status"}, {"id", std::string(5000, 'x')}})["ok"], Json(true));
    }

    void whoWaitsBeforeHelloGetsNoEventsAndIsClosed() {
        for (const bool isSlow : {false, true}) {
            Guests guests({{}, {}, 16, isSlow ? std::chrono::milliseconds(-1) : std::chrono::hours(1)});
            Peer peer = guests.connect();
            for (int i = 0; i < kManyRounds && guests.server->clientCount() == 0; ++i) guests.server->serve({});
            guests.server->serve({});
            QCOMPARE(guests.server->clientCount(), std::size_t(isSlow ? 0 : 1));
            guests.run.follow(true, 1);
            guests.server->addLine(0, "a", 0, "text");
            guests.server->serve({});
            QVERIFY(!peer.take() && peer.events.empty());
        }
    }

    /// Of a run that is paced elsewhere: how many ticks are wanted, and only those that were completed count.
    void wantedTicksAreCounted() {
        Guests guests;
        auto [ours, theirs] = std::move(Socket::pair().value());
        guests.server->adopt(std::move(theirs));
        Peer peer{std::move(ours)};
        peer.ask({{"op", "step"}, {"ticks", 3}});
        guests.server->serve({});
        for (std::uint64_t left = 3; left > 1; --left) {
            QCOMPARE(guests.server->wantedTicks(), left);
            guests.server->beforeTick();
            QVERIFY(guests.runner.tick().ok());
            guests.server->afterTick(true);
        }
        guests.server->beforeTick();
        guests.server->afterTick(false); // it was not completed
        const Json reply = guests.reply(peer);
        QCOMPARE(std::tuple(reply["ticks"], reply["tick"], reply["state"]), std::tuple(Json(2), Json(2), Json("ended")));
        QCOMPARE(guests.call(peer, {{"op", "reset"}})["error"], Json("refused")); // the window does that
        QVERIFY(!guests.server->isOver());
        peer.socket.close();
        for (int i = 0; i < kManyRounds && guests.server->clientCount() > 0; ++i) guests.server->serve({});
        QVERIFY(guests.server->isOver());
    }

    void whoConnectsAndGoesDoesNotEndTheServer() {
        Guests guests;
        {
            Peer peer = guests.connect();
            QCOMPARE(guests.call(peer, {{"op", "hello"}, {"token", kToken}})["ok"], Json(true));
        }
        for (int i = 0; i < kManyRounds && guests.server->clientCount() > 0; ++i) guests.server->serve({});
        QVERIFY(guests.server->clientCount() == 0 && !guests.server->isOver());
    }

    /// The pace of the window is that of the run, and the other way round.
    void aGuestFollowsThePaceAndChangesIt() {
        ExperimentRunner runner(std::make_unique<FakeWorld>(experimentOf({"a", "a2"})), RunOptions());
        auto clients = std::make_shared<std::atomic<std::size_t>>(0);
        Socket listener = Socket::listen("127.0.0.1", 0).value();
        const std::uint16_t port = listener.port();
        RunGuest guest(std::move(listener), {kToken, {}, 16, std::chrono::hours(1)}, clients);
        guest.begin(runner);
        Peer peer{Socket::connect("127.0.0.1", port).value()};
        LiveRate now{true, 2};
        std::optional<LiveRate> changed;
        const auto call = [&](const Json& request) -> Json {
            peer.ask(request);
            for (int i = 0; i < kManyRounds; ++i) {
                if ((changed = guest.serve(now))) now = *changed;
                if (auto message = peer.take()) return message->first;
            }
            return "no reply";
        };
        QCOMPARE(call({{"op", "hello"}, {"token", kToken}})["ok"], Json(true));
        QVERIFY(!changed);
        QCOMPARE(clients->load(), std::size_t(1));
        const Json status = call({{"op", "status"}});
        QCOMPARE(std::tuple(status["state"], status["speed"]), std::tuple(Json("running"), Json(2.)));
        QVERIFY(call({{"op", "run"}, {"speed", 0.5}})["ok"] == true && now.running && now.speed == 0.5);
        QVERIFY(call({{"op", "pause"}})["ok"] == true && !now.running);
        now = {false, 7};
        QVERIFY(!guest.serve(now)); // the pace of what is paused is no change
        QVERIFY(call({{"op", "console"}})["ok"] == true);
        guest.addLine({0.5, "a", 0, "a\x1b[31mb"});
        QVERIFY(call({{"op", "hold"}, {"robot", "a2"}})["ok"] == true);
        const auto line = std::ranges::find_if(peer.events, [](const auto& each) { return each.first["event"] == "console"; });
        QVERIFY(line != peer.events.end() && line->first["text"].get<std::string>().find('\x1b') == std::string::npos);
        guest.beforeTick();
        QVERIFY(runner.tick().ok());
        guest.afterTick(true);
        guest.end();
        QVERIFY(runner.tick().ok());
        QStringList held;
        for (const Command& each : runner.commands())
            if (const auto* hold = std::get_if<HoldCommand>(&each.what))
                held += QString::fromStdString(hold->robot) + (hold->held ? " held" : " free");
        QCOMPARE(held, (QStringList{"a2 held", "a2 free"}));
        QCOMPARE(clients->load(), std::size_t(0));
    }
    void moreThanThereAreSeats() {
        Guests guests({{}, {}, 1, std::chrono::hours(1)});
        Peer first = guests.connect(), second;
        QCOMPARE(guests.call(first, {{"op", "hello"}, {"token", kToken}})["ok"], Json(true));
        second = guests.connect();
        QCOMPARE(guests.reply(second)["error"], Json("full"));
        QCOMPARE(guests.server->clientCount(), std::size_t(1));
    }

    /// Why it has failed is in the status, with the controller of which robot was stopped.
    void theStatusNamesWhatFailed() {
        auto world = std::make_unique<FakeWorld>(experimentOf({"a", "a2"}));
        world->faultAt = 1;
        ExperimentRunner runner(std::move(world), RunOptions());
        ServedRun run(runner);
        RemoteServer server(run, {kToken, {}, 16, std::chrono::hours(1)});
        auto [ours, theirs] = std::move(Socket::pair().value());
        server.adopt(std::move(theirs));
        Peer peer{std::move(ours)};
        for (int i = 0; i < 2; ++i) {
            server.beforeTick();
            server.afterTick(runner.tick().ok());
        }
        peer.ask({{"op", "status"}});
        server.serve({});
        const auto reply = peer.take();
        QVERIFY(reply);
        QCOMPARE(std::tuple(reply->first["state"], reply->first["tick"]), std::tuple(Json("ended"), Json(1)));
        QCOMPARE(reply->first["diagnostics"].size(), std::size_t(1));
        QCOMPARE(reply->first["diagnostics"][0]["message"], reply->first["reason"]);
    }
};

QTEST_APPLESS_MAIN(HelloTest)
#include "hello_test.moc"
