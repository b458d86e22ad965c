#pragma once
#include "remote/operations.h"

namespace trundle {

/// The operations that change the run. Lives as long as one request.
class RunOperations {
public:
    explicit RunOperations(const RequestContext& request)
        : m_request(request), m_run(request.run), m_client(request.client), m_arguments(request.arguments) {}

    [[nodiscard]] Reply command();
    [[nodiscard]] Reply hold();
    [[nodiscard]] Reply place();
    [[nodiscard]] Reply push();
    [[nodiscard]] Reply restart();
    [[nodiscard]] Reply step();
    [[nodiscard]] Reply run();
    [[nodiscard]] Reply pause();
    [[nodiscard]] Reply reset();

private:
    [[nodiscard]] Reply commandDevice(const std::string& path);
    using SignalValues = std::vector<std::pair<std::string, std::vector<double>>>; ///< by path
    [[nodiscard]] Status setAll(const SignalValues& values);

    const RequestContext& m_request;
    ServedRun& m_run;
    RemoteClient& m_client;
    Arguments& m_arguments;
};

} // namespace trundle
