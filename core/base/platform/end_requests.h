#pragma once
#include <chrono>
#include <functional>

namespace trundle {

/// Handles SIGINT, SIGTERM and SIGHUP (unless ignored, as under nohup) as requests to end: the first calls `onRequest` with the
/// matching exit code, on a separate thread. A second signal, or a process still running after `timeout`, ends it immediately;
/// buffered files are flushed. Call once per process.
void watchEndRequests(std::function<void(int exitCode)> onRequest, std::chrono::seconds timeout);

} // namespace trundle
