#pragma once
#include <chrono>
#include <functional>

namespace trundle {

/// Calls `change` for each signal besides SIGINT, SIGTERM and SIGHUP that ends a process without a handler for it and is no crash: of
/// timers, batch systems, limits of processor time. Allocates nothing.
void forOtherEndSignals(void (*change)(int signal));

/// Handles SIGINT, SIGTERM and SIGHUP (unless ignored, as under nohup), and other such signals without a handler, as requests to end:
/// the first calls `onRequest` with the matching exit code, on a separate thread. A second signal, or a process still running after
/// `timeout`, ends it immediately; buffered files are flushed. Call once per process.
void watchEndRequests(std::function<void(int exitCode)> onRequest, std::chrono::seconds timeout);

} // namespace trundle
