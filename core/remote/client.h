#pragma once
// What a server keeps of one client: bytes in both directions, subscriptions, the step that it waits for. Without sockets.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "remote/frame.h"
#include "signals/block.h"

namespace trundle {

/// Signals that a client gets as doubles, in the order of the layout.
struct Subscription {
    std::vector<std::string> patterns;
    std::vector<SignalEntry> entries;
    std::uint64_t every = 0;   ///< ticks; 0: only as part of replies
    std::uint64_t skipped = 0; ///< events that were left out since the last one, as the client reads too slowly
};

/// A step that is in progress. Its reply comes when it is done.
struct StepJob {
    nlohmann::json id;
    std::uint64_t ticks = 0, done = 0;
    std::optional<std::uint32_t> subscription; ///< whose values are in the reply
};

class RemoteClient {
public:
    static constexpr std::uint32_t kProtocol = 1; ///< version of the protocol
    static constexpr FrameLimits kBeforeHello{4096, 0}, kRequest{256u << 10, 1u << 20};
    static constexpr std::size_t kMostSubscriptions = 64, kMostPatterns = 64;
    /// Requests are not read while more than this waits to be sent, and events are left out above the second.
    static constexpr std::size_t kMostUnsent = 1u << 20, kMostUnsentForEvents = 256u << 10;

    static constexpr std::size_t kMostDuringStep = 64u << 10; ///< of further requests, until the step is done

    /// `authorized`: it needs no token, and gets the console from the start.
    explicit RemoteClient(bool authorized) : console(authorized), m_reader(authorized ? kRequest : kBeforeHello), m_authorized(authorized) {}

    // --- received ---
    /// A `pause` that comes next ends a step that is in progress.
    void receive(std::span<const char> bytes);
    /// Whether more may be read from it now.
    [[nodiscard]] bool canReceive() const {
        return !m_closing && unsent().size() < kMostUnsent && (!step || m_reader.waiting() < kMostDuringStep);
    }
    /// Whether a request of it can be answered now.
    [[nodiscard]] bool hasRequest() const { return !step && !m_closing && unsent().size() < kMostUnsent && m_reader.hasNext(); }
    [[nodiscard]] Result<std::optional<Frame>> nextRequest() { return m_reader.next(); }

    [[nodiscard]] bool isAuthorized() const { return m_authorized; }
    void authorize();

    // --- to send ---
    void send(const nlohmann::ordered_json& message, std::string_view bytes = {});
    /// Sends an event unless too much is waiting. False: it was left out.
    bool sendEvent(const nlohmann::ordered_json& message, std::string_view bytes = {});
    [[nodiscard]] std::string_view unsent() const { return std::string_view(m_out).substr(m_sent); }
    void sent(std::size_t bytes);
    /// No more is read; it ends when all is sent.
    void closeAfterSending() { m_closing = true; }
    [[nodiscard]] bool isDone() const { return m_closing && unsent().empty(); }

    std::optional<StepJob> step;
    std::map<std::uint32_t, Subscription> subscriptions;
    std::uint32_t lastSubscription = 0;
    bool console; ///< it gets what controllers print
    std::uint64_t droppedLines = 0;

private:
    FrameReader m_reader;
    std::string m_out;
    std::size_t m_sent = 0; ///< bytes at the start of m_out
    bool m_authorized, m_closing = false;
};

/// 16 hexadecimal digits.
[[nodiscard]] std::string hashDigits(std::uint64_t hash);
/// The values of the signals as little-endian doubles.
[[nodiscard]] std::string valuesOf(const Subscription& subscription, const SignalBlock& block);

} // namespace trundle
