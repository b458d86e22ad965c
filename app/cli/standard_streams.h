#pragma once
#include <string_view>

namespace trundle {

// Module code may print to the standard descriptors, close them or replace them; what it prints is cleaned (output_cleaner.h). The
// program's own output uses separate copies.

/// Call first in main(): opens closed standard descriptors on /dev/null, so that no other file gets their numbers. Starts the
/// process that cleans the output of modules.
void keepStandardStreams();
/// Before code of modules runs: redirects standard output and standard error to the cleaner; from then on only writeOut() reaches
/// the original standard output, and only writeMessage() the original standard error.
void redirectStandardOutput();
/// After redirectStandardOutput(): restores standard error and reopens closed standard descriptors.
void restoreStandardStreams();
/// Writes to the original standard error, after what modules have written so far.
void writeMessage(std::string_view text);

[[nodiscard]] int resultsFile();  ///< the original standard output; -1: it was closed, either at the start or by a module
[[nodiscard]] int messagesFile(); ///< the original standard error, or /dev/null

} // namespace trundle
