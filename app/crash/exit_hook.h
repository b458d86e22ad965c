#pragma once

namespace trundle {

/// Calls `hook` whenever code calls exit(), quick_exit(), _exit() or _Exit(); if it returns, the process ends as asked. Handlers
/// of exit() that are registered later run before the hook where the C library itself ends the program, for example in errx():
/// call this again after libraries are loaded. Of exit() it is called more than once. nullptr: none.
void setExitHook(void (*hook)());

/// Ends the process without any handlers or messages, once the output of modules is passed on. Async-signal-safe.
[[noreturn]] void endProcess(int code);

} // namespace trundle
