#pragma once

namespace trundle {

// Code of modules may print to the standard descriptors, close them and put others in their place. What the program itself has to say
// goes through copies of its own.

/// First of all in main(): where a standard descriptor is closed it leads nowhere from now on, so that no file gets its number.
void keepStandardStreams();
/// From now on what anybody prints to standard output goes to standard error; only writeOut() still reaches the real one.
void redirectStandardOutput();
/// After redirectStandardOutput(): gives standard error back to the program, and closed descriptors what they led to.
void restoreStandardStreams();

[[nodiscard]] int resultsFile();  ///< the real standard output; -1: it was closed, when the program started or by a module
[[nodiscard]] int messagesFile(); ///< the real standard error, or where nobody reads

} // namespace trundle
