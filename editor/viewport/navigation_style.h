#pragma once
#include <QString>
#include <Qt>

#include "editor/widgets/preferences.h"

namespace trundle {

enum class CameraDrag { None, Orbit, Pan, Zoom, Fly };

/// What a drag with a button does to the camera. None: it is not navigation's. The right button is never None: a click with it
/// opens the menu, and while it is held the keys fly.
[[nodiscard]] CameraDrag cameraDrag(NavigationStyle style, Qt::MouseButton button, Qt::KeyboardModifiers held);
/// The same for people: which button does what.
[[nodiscard]] QString navigationWords(NavigationStyle style);

} // namespace trundle
