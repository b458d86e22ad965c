#pragma once

namespace trundle {

/// Lowers the priority of the calling thread, and of those it starts later, below the program's other threads.
void lowerThreadPriority();

} // namespace trundle
