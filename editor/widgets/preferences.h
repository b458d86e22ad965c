#pragma once
#include "editor/widgets/theme.h"

namespace trundle {

enum class ThemeChoice { System, Light, Dark };
enum class WrapLines { InNarrowPanes, Always, Never };
/// Which buttons of the mouse move the camera of a 3D view.
enum class NavigationStyle { Trundle, Blender, Cad };

/// What a person chose for the whole program, as QSettings keeps it.
struct Preferences {
    ThemeChoice theme = ThemeChoice::System;
    FontSizes fonts;
    WrapLines wrapLines = WrapLines::InNarrowPanes;
    NavigationStyle navigation = NavigationStyle::Trundle;

    bool operator==(const Preferences&) const = default;
};

inline constexpr int kSmallestFont = 10, kLargestInterfaceFont = 20, kLargestTextFont = 32; ///< logical pixels

/// What is missing or cannot be read has its default.
[[nodiscard]] Preferences loadPreferences();
void savePreferences(const Preferences& preferences);
[[nodiscard]] ThemeKind themeOf(ThemeChoice choice);

} // namespace trundle
