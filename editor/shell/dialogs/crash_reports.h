#pragma once
#include <QString>

namespace trundle {

/// What the files in `folder` report about windows that crashed, one line each with its time, newest last; "" if there are none.
/// Removes the files.
[[nodiscard]] QString takeCrashReports(const QString& folder);

} // namespace trundle
