#pragma once
#include <string_view>

namespace trundle {

/// Whether a controller's port for devices of the kind `port` ("": any) binds a device of the kind `device`: of the same kind, or of one that
/// has the same signals.
[[nodiscard]] bool portFits(std::string_view port, std::string_view device);

} // namespace trundle
