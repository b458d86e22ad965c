#pragma once
#include <string>

#include <QString>

namespace trundle {

/// A UTF-8 text of the core as a QString.
[[nodiscard]] inline QString toQString(const std::string& text) { return QString::fromStdString(text); }

} // namespace trundle
