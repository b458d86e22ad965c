#include "remote/server.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <random>

#include <trundle/abi.h>

#include "remote/dispatch.h"

namespace trundle {

using Json = nlohmann::ordered_json;

namespace {

constexpr std::size_t kReadAtOnce = 64u << 10;                  ///< of one client in a round
constexpr int kRequestsAtOnce = 32;                             ///< the same
constexpr std::chrono::microseconds kExchangeEvery{500};        ///< while ticks follow each other
constexpr std::chrono::milliseconds kWaitForSeat{100};          ///< of who connects while there are too many: some may have gone unseen
constexpr const char* kLineSeverities[] = {"info", "warning", "error"};

/// Takes the same time wherever they differ.
bool isSame(const std::string& given, const std::string& token) {
    unsigned different = given.size() == token.size() ? 0 : 1;
    for (std::size_t i = 0; i < token.size(); ++i)
        different |= static_cast<unsigned>(static_cast<unsigned char>(token[i]) ^ static_cast<unsigned char>(i < given.size() ? given[i] : 0));
    return different == 0;
}

/// The "id" of a request, which its reply repeats: a whole number or a short text.
nlohmann::json idOf(const nlohmann::json& request) {
    const auto id = request.find("id");
    if (id == request.end()) return nullptr;
    if (id->is_number_integer() || (id->is_string() && id->get_ref<const std::string&>().size() <= 64)) return *id;
    return nullptr;
}

Json messageOf(const nlohmann::json& id, const Reply& reply) {
    Json message;
    message["id"] = id;
    message["ok"] = reply.error.empty();
    if (!reply.error.empty()) {
        message["error"] = reply.error;
        message["message"] = reply.message;
    }
    message.update(reply.members);
    return message;
}

} // namespace

std::string randomToken() {
    std::random_device system;
    std::string token;
    for (int i = 0; i < 4; ++i) {
        char digits[9];
        std::snprintf(digits, sizeof digits, "%08x", static_cast<unsigned>(system()));
        token += digits;
    }
    return token;
}

void RemoteServer::adopt(Socket socket) {
    m_connections.push_back(std::make_unique<Connection>(Connection{std::move(socket), RemoteClient(true), Clock::now(), true, false}));
}

void RemoteServer::fail() {
    const Json event{{"event", "failed"}, {"diagnostics", problemsJson(m_run.built().problems, m_run.built().sources)}};
    for (const auto& connection : m_connections) {
        connection->client.send(event);
        send(*connection);
    }
}

void RemoteServer::serve(std::chrono::milliseconds longest) {
    exchange(m_run.isPacedElsewhere() ? std::chrono::nanoseconds(0) : timeToWait(longest));
    answerAll();
    if (!m_run.isPacedElsewhere() && (isStepping() || isTickDue(Clock::now()))) tick();
    finishSteps();
    announce();
    for (const auto& connection : m_connections) {
        send(*connection);
        publishLate(connection->client);
    }
    removeGone();
}

bool RemoteServer::isStepping() const {
    return m_run.state() == ServedState::Paused &&
           std::ranges::any_of(m_connections, [](const auto& each) { return each->client.step.has_value(); });
}

bool RemoteServer::isTickDue(Clock::time_point now) {
    if (m_run.state() != ServedState::Running) {
        m_paced = false;
        return false;
    }
    if (!std::exchange(m_paced, true)) m_pace.restart(now);
    return m_pace.due(now, m_run.world().experiment().settings.tick, m_run.speed()) <= now;
}

std::chrono::nanoseconds RemoteServer::timeToWait(std::chrono::milliseconds longest) {
    const bool waiting = std::ranges::any_of(m_connections, [](const auto& each) { return each->client.hasRequest(); });
    if (waiting || isStepping()) return {};
    if (m_run.state() != ServedState::Running) return longest;
    const Clock::time_point now = Clock::now();
    if (isTickDue(now)) return {};
    const auto due = m_pace.due(now, m_run.world().experiment().settings.tick, m_run.speed());
    return std::min<std::chrono::nanoseconds>(longest, due - now);
}

/// Between ticks that follow each other, sockets are served at most once in a while: that costs more than a tick of a small world.
void RemoteServer::exchange(std::chrono::nanoseconds atMost) {
    const Clock::time_point now = Clock::now();
    const bool isBusy = isStepping() || (m_run.state() == ServedState::Running && m_run.speed() <= 0);
    if (isBusy && now - m_exchanged < kExchangeEvery) return;
    std::vector<SocketWait> waits{{m_listener.descriptor(), m_listener.isOpen(), false}};
    for (const auto& each : m_connections)
        waits.push_back({each->socket.descriptor(), each->client.canReceive(), !each->client.unsent().empty()});
    waitForSockets(waits, atMost);
    m_exchanged = Clock::now();
    for (std::size_t i = 0; i < m_connections.size(); ++i) {
        Connection& connection = *m_connections[i];
        if (waits[i + 1].canRead) receive(connection);
        else if (waits[i + 1].hasEnded) connection.gone = true; // also one that waits for the end of a step
        if (waits[i + 1].canWrite) send(connection);
        if (!connection.client.isAuthorized() && m_exchanged - connection.since > m_options.helloTime) connection.gone = true;
    }
    if (waits[0].canRead) accept();
}

void RemoteServer::accept() {
    const auto isFull = [&] { return m_connections.size() >= m_options.mostClients; };
    if (!isFull()) m_full.reset();
    while (!isFull() || m_exchanged - m_full.value_or(m_exchanged) > kWaitForSeat) {
        std::optional<Socket> socket = m_listener.accept();
        if (!socket) return;
        RemoteClient client(false);
        if (isFull()) {
            client.send({{"id", nullptr}, {"ok", false}, {"error", "full"}, {"message", "the server has too many clients"}});
            (void)socket->write(client.unsent());
            continue;
        }
        m_connections.push_back(std::make_unique<Connection>(Connection{std::move(*socket), std::move(client), Clock::now(), false, false}));
    }
    if (!m_full) m_full = m_exchanged;
}

void RemoteServer::receive(Connection& connection) {
    std::array<char, kReadAtOnce> bytes;
    const std::optional<std::size_t> got = connection.socket.read(bytes);
    if (!got) connection.gone = true;
    else connection.client.receive(std::span(bytes).first(*got));
}

void RemoteServer::send(Connection& connection) {
    while (!connection.gone && !connection.client.unsent().empty()) {
        const std::optional<std::size_t> sent = connection.socket.write(connection.client.unsent());
        if (!sent) connection.gone = true;
        else if (*sent == 0) return;
        else connection.client.sent(*sent);
    }
}

void RemoteServer::answerAll() {
    for (const auto& connection : m_connections) {
        RemoteClient& client = connection->client;
        for (int i = 0; i < kRequestsAtOnce && client.hasRequest(); ++i) {
            Result<std::optional<Frame>> frame = client.nextRequest();
            if (frame) {
                if (frame.value()) answer(client, *frame.value());
                continue;
            }
            client.send(messageOf(nullptr, Reply::failed("bad_frame", frame.error().message)));
            client.closeAfterSending();
        }
    }
}

void RemoteServer::answer(RemoteClient& client, const Frame& frame) {
    const nlohmann::json request = nlohmann::json::parse(frame.json, nullptr, false);
    if (!request.is_object()) {
        client.send(messageOf(nullptr, Reply::failed("bad_request", "a request must be a JSON object")));
        if (!client.isAuthorized()) client.closeAfterSending();
        return;
    }
    Arguments arguments(request);
    const nlohmann::json id = idOf(request);
    const std::string operation = arguments.text("op");
    Reply reply;
    if (operation == "hello" || !client.isAuthorized()) reply = hello(client, arguments);
    else reply = trundle::answer(operation, {m_run, client, arguments, frame.bytes});
    if (operation == "reset" && (reply.error.empty() || reply.error == kResetFailed)) bindAgain(); // else the run is as it was
    if (reply.later) client.step->id = id;
    else client.send(messageOf(id, reply), reply.bytes);
}

Reply RemoteServer::hello(RemoteClient& client, Arguments& arguments) {
    const std::string operation = arguments.text("op"), token = arguments.text("token", "");
    const std::uint64_t protocol = arguments.count("protocol", UINT32_MAX, RemoteClient::kProtocol);
    Reply reply;
    if (operation != "hello") reply = Reply::failed("unauthorized", "the first request must be hello, with the token");
    else if (const std::string problem = arguments.problem(); !problem.empty()) reply = Reply::failed("bad_request", problem);
    else if (protocol != RemoteClient::kProtocol)
        reply = Reply::failed("refused", "the protocol's version is " + std::to_string(RemoteClient::kProtocol));
    else if (!client.isAuthorized() && !isSame(token, m_options.token)) reply = Reply::failed("unauthorized", token.empty() ? "a token is needed, that of the served run" : "the token is wrong");
    if (!reply.error.empty()) {
        client.closeAfterSending();
        return reply;
    }
    client.authorize();
    reply.members = {{"program", "trundle"}, {"version", TRUNDLE_SDK_VERSION}, {"protocol", RemoteClient::kProtocol},
                     {"experiment", m_options.experiment}};
    reply.members.update(stateOf(m_run));
    return reply;
}

void RemoteServer::tick() {
    if (!countStep()) return;
    m_run.beginTick();
    m_pace.ticked();
    afterTick(m_run.runner().tick().ok());
}

void RemoteServer::beforeTick() {
    (void)countStep();
    m_run.beginTick();
}

void RemoteServer::afterTick(bool good) {
    if (m_counted && m_run.world().ticks() == m_countedAfter) --m_counted->done; // it was not completed
    m_counted = nullptr;
    m_run.endTick(good);
    publishTick();
}

std::uint64_t RemoteServer::wantedTicks() const {
    std::uint64_t most = 0;
    for (const auto& each : m_connections)
        if (const auto& step = each->client.step) most = std::max(most, step->ticks - step->done);
    return most;
}

void RemoteServer::close() {
    m_run.endTick(false);
    finishSteps();
    announce();
    for (const auto& connection : m_connections) send(*connection);
    m_connections.clear();
    m_listener.close();
}

/// Of several steps one is executed after the other. False: it was one of no ticks.
bool RemoteServer::countStep() {
    m_counted = nullptr;
    if (m_run.state() != ServedState::Paused) return true;
    for (std::size_t i = 0; i < m_connections.size(); ++i) {
        RemoteClient& client = m_connections[(m_next + i) % m_connections.size()]->client;
        if (!client.step) continue;
        m_next = (m_next + i) % m_connections.size();
        if (client.step->done >= client.step->ticks) return false;
        ++client.step->done;
        m_counted = &*client.step;
        m_countedAfter = m_run.world().ticks();
        return true;
    }
    return true;
}

void RemoteServer::publishTick() {
    for (const auto& connection : m_connections) publish(connection->client);
}

void RemoteServer::publish(RemoteClient& client) {
    const std::uint64_t tick = m_run.world().ticks();
    for (auto& [number, subscription] : client.subscriptions)
        if (subscription.every > 0 && tick % subscription.every == 0) publish(client, number, subscription);
}

void RemoteServer::publish(RemoteClient& client, std::uint32_t number, Subscription& subscription) {
    Json event{{"event", "signals"}, {"subscription", number}, {"tick", m_run.world().ticks()}, {"time", timeOf(m_run)}};
    if (subscription.skipped > 0) event["skipped"] = subscription.skipped;
    if (client.sendEvent(event, valuesOf(subscription, m_run.world().block()))) subscription.skipped = 0;
    else ++subscription.skipped;
}

/// A slow client gets the newest state in place of all that it has missed, once it has read the rest.
void RemoteServer::publishLate(RemoteClient& client) {
    if (!m_run.exists() || !client.unsent().empty()) return;
    for (auto& [number, subscription] : client.subscriptions) {
        if (subscription.skipped == 0) continue;
        --subscription.skipped;
        publish(client, number, subscription);
    }
}

void RemoteServer::finishStep(RemoteClient& client) {
    const StepJob job = *std::exchange(client.step, std::nullopt);
    Reply reply;
    reply.members = stateOf(m_run);
    reply.members["ticks"] = job.done;
    if (job.subscription && m_run.exists())
        if (const auto found = client.subscriptions.find(*job.subscription); found != client.subscriptions.end())
            reply.bytes = valuesOf(found->second, m_run.world().block());
    client.send(messageOf(job.id, reply), reply.bytes);
}

/// Also those that another client has cut off, by a reset or by running.
void RemoteServer::finishSteps() {
    for (std::size_t i = 0; i < m_connections.size(); ++i) {
        RemoteClient& client = m_connections[i]->client;
        if (!client.step || (client.step->done < client.step->ticks && m_run.state() == ServedState::Paused)) continue;
        finishStep(client);
        m_next = i + 1;
    }
}

void RemoteServer::announce() {
    const ServedState state = m_run.state();
    if (state == std::exchange(m_announced, state)) return;
    Json event{{"event", "state"}};
    event.update(stateOf(m_run));
    for (const auto& connection : m_connections)
        if (connection->client.isAuthorized()) (void)connection->client.sendEvent(event);
}

void RemoteServer::bindAgain() {
    Json event{{"event", "reset"}};
    event.update(stateOf(m_run));
    for (const auto& connection : m_connections) {
        RemoteClient& client = connection->client;
        if (client.step) client.step->ticks = client.step->done; // of the run before
        for (auto& [number, subscription] : client.subscriptions) {
            subscription.entries.clear();
            subscription.skipped = 0;
            if (m_run.exists()) bindSignals(subscription, m_run.world().layout());
        }
        if (client.isAuthorized()) (void)client.sendEvent(event);
    }
}

void RemoteServer::removeGone() {
    std::erase_if(m_connections, [&](const auto& each) {
        if (!each->gone && !each->client.isDone()) return false;
        m_over = m_over || each->adopted;
        return true;
    });
}

void RemoteServer::addLine(double time, const std::string& who, int severity, const std::string& text) {
    const char* const severityName = kLineSeverities[std::clamp<int>(severity, TRUNDLE_INFO, TRUNDLE_ERROR) - TRUNDLE_INFO];
    for (const auto& connection : m_connections) {
        RemoteClient& client = connection->client;
        if (!client.console) continue;
        Json event{{"event", "console"}, {"time", time}, {"who", who}, {"severity", severityName}, {"text", text}};
        if (client.droppedLines > 0) event["dropped"] = client.droppedLines;
        if (client.sendEvent(event)) client.droppedLines = 0;
        else ++client.droppedLines;
    }
}

} // namespace trundle
