#pragma once
#include <chrono>
#include <functional>

namespace trundle {

/// From now on SIGINT, SIGTERM and SIGHUP (where that is not ignored, as under nohup) are requests to end: the first calls `onRequest`
/// with the exit code that fits, on a thread of its own. A second one, or a program that is still there after `patience`, ends
/// it at once, its logs written out. Once per program.
void watchEndRequests(std::function<void(int exitCode)> onRequest, std::chrono::seconds patience);

} // namespace trundle
