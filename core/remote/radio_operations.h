#pragma once
#include "remote/operations.h"

namespace trundle {

class Medium;

/// Packets of a robot's radio, between two ticks: what its controller does in an update. Lives as long as one request.
class RadioOperations {
public:
    explicit RadioOperations(const RequestContext& request) : m_request(request) {}

    /// Queues the bytes of the request as a packet.
    [[nodiscard]] Reply send();
    /// Takes the oldest packet that was received, if there is one.
    [[nodiscard]] Reply receive();

private:
    struct Radio {
        Medium* medium = nullptr;
        std::uint32_t number = 0;
        Reply wrong; ///< if there is no such radio, or a controller has it
    };
    [[nodiscard]] Radio radio(const std::string& device);

    const RequestContext& m_request;
};

} // namespace trundle
