#pragma once
#include <memory>

#include "control/backend.h"

namespace trundle {

class Medium;

/// The radios of a medium in this process, which must outlive the result.
[[nodiscard]] std::shared_ptr<RadioAccess> radiosOf(Medium& medium);

} // namespace trundle
