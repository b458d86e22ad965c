#pragma once
// What the operations of the remote control have in common. resources/guide/remote.md describes them.

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "remote/arguments.h"
#include "remote/client.h"
#include "remote/served_run.h"

namespace trundle {

constexpr std::uint64_t kMostTicks = 1'000'000'000; ///< of one request

inline constexpr const char* kResetFailed = "failed"; ///< error of a reset after which there is no run

struct Reply {
    nlohmann::ordered_json members = nlohmann::ordered_json::object();
    std::string bytes;
    std::string error, message; ///< why it failed: a code for programs, a text for people. Empty: it did not
    bool later = false;         ///< a step has begun, whose reply comes when it is done

    [[nodiscard]] static Reply failed(std::string error, std::string message);
    [[nodiscard]] static Reply of(const Status& status);
};

/// What an operation works on.
struct RequestContext {
    ServedRun& run;
    RemoteClient& client;
    Arguments& arguments;
    std::string_view bytes = {}; ///< behind the JSON

    /// The reply if something is wrong with the members of the request.
    [[nodiscard]] std::optional<Reply> mistake() const;
};

/// tick, time, state and, if the run is over or at its Duration, the reason.
[[nodiscard]] nlohmann::ordered_json stateOf(ServedRun& run);
/// Time in s, as logs give it.
[[nodiscard]] double timeOf(ServedRun& run);
/// The same and the settings of the run.
[[nodiscard]] nlohmann::ordered_json statusOf(ServedRun& run);
/// Finds the signals of a subscription, also again after a reset.
void bindSignals(Subscription& subscription, const SignalLayout& layout);

} // namespace trundle
