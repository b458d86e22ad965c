#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "control/host/control_page.h"

namespace trundle {

/// Sends the records of controllers to the run.
class RecordSender {
public:
    virtual ~RecordSender() = default;
    /// Adds a record; ignored in a thread of a module.
    virtual void record(HostRecord kind, std::uint32_t controller, std::string_view bytes) = 0;
    /// Adds a record and waits for the reply.
    [[nodiscard]] virtual std::string ask(HostRecord kind, std::uint32_t controller, std::string_view bytes) = 0;
};

} // namespace trundle
