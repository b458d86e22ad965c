#pragma once
#include "remote/operations.h"

namespace trundle {

/// The operations that leave the run as it is. Lives as long as one request.
class QueryOperations {
public:
    explicit QueryOperations(const RequestContext& request)
        : m_request(request), m_run(request.run), m_client(request.client), m_arguments(request.arguments) {}

    [[nodiscard]] Reply status();
    [[nodiscard]] Reply list();
    [[nodiscard]] Reply describe();
    [[nodiscard]] Reply subscribe();
    [[nodiscard]] Reply unsubscribe();
    [[nodiscard]] Reply read();
    [[nodiscard]] Reply hash();
    [[nodiscard]] Reply image();
    [[nodiscard]] Reply objects();
    [[nodiscard]] Reply console();

private:
    [[nodiscard]] Reply readDevice(const std::string& path);
    [[nodiscard]] Reply readSubscription();
    [[nodiscard]] nlohmann::ordered_json numbersOf(const SignalEntry& entry);

    const RequestContext& m_request;
    ServedRun& m_run;
    RemoteClient& m_client;
    Arguments& m_arguments;
};

} // namespace trundle
