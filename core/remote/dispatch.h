#pragma once
#include <string>

#include "remote/operations.h"

namespace trundle {

/// Answers any request of a client that has given the token.
[[nodiscard]] Reply answer(const std::string& operation, const RequestContext& request);

} // namespace trundle
