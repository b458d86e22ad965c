#pragma once

namespace trundle {

/// From now on this thread, and those that it starts, leave the processors to the program's other threads first.
void letOthersGoFirst();

} // namespace trundle
