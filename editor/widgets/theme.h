#pragma once
#include <QColor>
#include <QFont>
#include <QIcon>
#include <QString>

class QApplication;
class QWidget;

namespace trundle {

enum class ThemeKind { Light, Dark };

/// Colours beyond Qt's palette, chosen for a contrast of at least 4.5 : 1 on Base.
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

/// Heights in logical pixels.
struct FontSizes {
    int interface = 13, text = 13; ///< `text`: of all fixed-pitch text
    bool operator==(const FontSizes&) const = default;
};

/// Sets palette, style sheet and fonts of the application, and plain text display (plain_text.h). The result does not depend on
/// platform or desktop.
void applyTheme(QApplication& application, ThemeKind kind, const FontSizes& sizes = {});
[[nodiscard]] ThemeKind currentTheme();
/// The desktop's preference when the program started: dark if its windows are. Call it before the first applyTheme().
[[nodiscard]] ThemeKind systemTheme();
[[nodiscard]] QFont monospaceFont();
/// Gives the widget the fixed-pitch font in the current theme's size, also after later theme changes.
void useMonospaceFont(QWidget& widget);
[[nodiscard]] QColor ink(Ink which);
/// An icon of resources/icons in the theme's text colour, sharp at any scale. Empty if there is no such file.
[[nodiscard]] QIcon themedIcon(const QString& name);
[[nodiscard]] QIcon inkedIcon(const QString& name, Ink which); ///< the same in another colour

} // namespace trundle
