#pragma once

namespace trundle {

// Module code may print to the standard descriptors, close them or replace them. The program's own output uses separate copies.

/// Call first in main(): opens closed standard descriptors on /dev/null, so that no other file gets their numbers.
void keepStandardStreams();
/// Redirects standard output to standard error; from then on only writeOut() reaches the original standard output.
void redirectStandardOutput();
/// After redirectStandardOutput(): restores standard error and reopens closed standard descriptors.
void restoreStandardStreams();

[[nodiscard]] int resultsFile();  ///< the original standard output; -1: it was closed, either at the start or by a module
[[nodiscard]] int messagesFile(); ///< the original standard error, or /dev/null

} // namespace trundle
