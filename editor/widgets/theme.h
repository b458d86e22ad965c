#pragma once
#include <QColor>
#include <QFont>
#include <QIcon>
#include <QString>

class QApplication;
class QWidget;

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

/// Heights in logical pixels.
struct FontSizes {
    int interface = 13, text = 13; ///< `text`: of whatever is in the fixed-pitch font
    bool operator==(const FontSizes&) const = default;
};

/// Sets palette, style sheet and fonts of the application, and that text is shown plainly (plain_text.h). The same on every platform and with no desktop.
void applyTheme(QApplication& application, ThemeKind kind, const FontSizes& sizes = {});
[[nodiscard]] ThemeKind currentTheme();
/// What the desktop asked for when the program started: dark where its windows are. To be called before the first applyTheme().
[[nodiscard]] ThemeKind systemTheme();
[[nodiscard]] QFont monospaceFont();
/// The widget has the fixed-pitch font from now on, in the size that applyTheme() gives it.
void useMonospaceFont(QWidget& widget);
[[nodiscard]] QColor ink(Ink which);
/// An icon of resources/icons, drawn in the theme's text colour, sharp at any scale. Empty where there is none of that name.
[[nodiscard]] QIcon themedIcon(const QString& name);
[[nodiscard]] QIcon inkedIcon(const QString& name, Ink which); ///< the same in another colour

} // namespace trundle
