#pragma once
#include <QColor>
#include <QFont>
#include <QIcon>
#include <QString>

class QApplication;

namespace trundle {

enum class ThemeKind { Light, Dark };

/// Colours beyond Qt's palette, chosen for contrast of at least 4.5 : 1 on Base.
enum class Ink {
    Text,
    Faint,
    Accent,
    Error,
    Warning,
    Hint,
    Good,
    Keyword,
    Number,
    String,
    Comment,
    Type,
    AxisX,
    AxisY,
    AxisZ,
    Line
};

/// Sets palette, style sheet and font of the application. The same on every platform and with no desktop.
void applyTheme(QApplication& application, ThemeKind kind);
[[nodiscard]] ThemeKind currentTheme();
[[nodiscard]] QFont monospaceFont();
[[nodiscard]] QColor ink(Ink which);
/// An icon of resources/icons, drawn in the theme's text colour, sharp at any scale. Empty where there is none of that name.
[[nodiscard]] QIcon themedIcon(const QString& name);

} // namespace trundle
