#pragma once
#include <QString>
#include <Qt>

#include "editor/widgets/preferences.h"

namespace trundle {

enum class CameraDrag { None, Orbit, Pan, Zoom, Fly };

/// The camera motion for a drag with that button; None if navigation does not use it. The right button is never None: clicking it
/// opens the menu, and holding it enables the flying keys.
[[nodiscard]] CameraDrag cameraDrag(NavigationStyle style, Qt::MouseButton button, Qt::KeyboardModifiers held);
/// Description of the style for the user: which button does what.
[[nodiscard]] QString navigationWords(NavigationStyle style);

} // namespace trundle
