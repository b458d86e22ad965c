#pragma once
#include <QLabel>
#include <QLatin1String>

namespace trundle {

/// The look of a text that a panel shows in place of its contents.
inline void styleEmptyPage(QLabel& label, const char* name) {
    label.setObjectName(QLatin1String(name));
    label.setAlignment(Qt::AlignCenter);
    label.setWordWrap(true);
    label.setMargin(16);
    label.setForegroundRole(QPalette::PlaceholderText);
}

} // namespace trundle
