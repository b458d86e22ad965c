#pragma once
#include <functional>

#include <QColor>
#include <QFont>
#include <QIcon>
#include <QPalette>
#include <QString>

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

[[nodiscard]] ThemeKind currentTheme();
/// For applyTheme() (apply_theme.h) alone: what the functions below answer from now on.
void setCurrentTheme(ThemeKind kind, const FontSizes& sizes);
/// The desktop's preference when the program started: dark if its windows are. Call it before the first applyTheme().
[[nodiscard]] ThemeKind systemTheme();
[[nodiscard]] QPalette themePalette();
[[nodiscard]] QFont interfaceFont();
[[nodiscard]] QFont monospaceFont();
/// Gives the widget a font that depends on the theme, and again after each theme change.
void useFont(QWidget& widget, std::function<QFont()> font);
void useMonospaceFont(QWidget& widget); ///< useFont() with monospaceFont()
/// A length that is `atDefault` pixels at the default interface font, for the current interface font. Sizes of small text and of
/// what surrounds text are scaled by this, so that they follow the font that the user has chosen.
[[nodiscard]] int scaledToFont(int atDefault);
/// Fixed-pitch font for numbers in narrow places; smaller than the interface font, and grows with it.
[[nodiscard]] QFont figuresFont(int atDefault = 11);
[[nodiscard]] QColor ink(Ink which);
/// An icon of resources/icons in the theme's text colour, sharp at any scale. Empty if there is no such file.
[[nodiscard]] QIcon themedIcon(const QString& name);
[[nodiscard]] QIcon inkedIcon(const QString& name, Ink which); ///< the same in another colour

} // namespace trundle
