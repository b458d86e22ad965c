#pragma once
#include "editor/widgets/theme.h"

namespace trundle {

enum class ThemeChoice { System, Light, Dark };
enum class WrapLines { InNarrowPanes, Always, Never };
/// Mouse buttons that move the camera of a viewport.
enum class NavigationStyle { Trundle, Blender, Cad };

/// The user's preferences for the whole program, saved in QSettings.
struct Preferences {
    ThemeChoice theme = ThemeChoice::System;
    FontSizes fonts;
    WrapLines wrapLines = WrapLines::InNarrowPanes;
    NavigationStyle navigation = NavigationStyle::Trundle;

    bool operator==(const Preferences&) const = default;
};

inline constexpr int kSmallestFont = 10, kLargestInterfaceFont = 20, kLargestTextFont = 32; ///< logical pixels

/// Missing or invalid settings have their default.
[[nodiscard]] Preferences loadPreferences();
void savePreferences(const Preferences& preferences);
[[nodiscard]] ThemeKind themeOf(ThemeChoice choice);

} // namespace trundle
