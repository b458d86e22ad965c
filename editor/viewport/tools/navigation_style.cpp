#include "editor/viewport/tools/navigation_style.h"

#include <QCoreApplication>

namespace trundle {
namespace {

struct DragRow {
    Qt::MouseButton button;
    Qt::KeyboardModifiers held; ///< exactly these modifiers
    CameraDrag drag;
};

// The first matching row applies. Alt with the left button serves mice and touchpads without a middle button.
constexpr DragRow kTrundle[] = {{Qt::MiddleButton, Qt::ShiftModifier, CameraDrag::Pan},
                                {Qt::MiddleButton, Qt::NoModifier, CameraDrag::Orbit},
                                {Qt::RightButton, Qt::ShiftModifier, CameraDrag::Pan},
                                {Qt::RightButton, Qt::NoModifier, CameraDrag::Orbit},
                                {Qt::LeftButton, Qt::AltModifier | Qt::ShiftModifier, CameraDrag::Pan},
                                {Qt::LeftButton, Qt::AltModifier, CameraDrag::Orbit}};
constexpr DragRow kBlender[] = {{Qt::MiddleButton, Qt::ShiftModifier, CameraDrag::Pan},
                                {Qt::MiddleButton, Qt::ControlModifier, CameraDrag::Zoom},
                                {Qt::MiddleButton, Qt::NoModifier, CameraDrag::Orbit},
                                {Qt::RightButton, Qt::NoModifier, CameraDrag::Fly},
                                {Qt::LeftButton, Qt::AltModifier | Qt::ShiftModifier, CameraDrag::Pan},
                                {Qt::LeftButton, Qt::AltModifier | Qt::ControlModifier, CameraDrag::Zoom},
                                {Qt::LeftButton, Qt::AltModifier, CameraDrag::Orbit}};
constexpr DragRow kCad[] = {{Qt::MiddleButton, Qt::ShiftModifier, CameraDrag::Orbit},
                            {Qt::MiddleButton, Qt::ControlModifier, CameraDrag::Zoom},
                            {Qt::MiddleButton, Qt::NoModifier, CameraDrag::Pan},
                            {Qt::RightButton, Qt::NoModifier, CameraDrag::Orbit},
                            {Qt::LeftButton, Qt::AltModifier | Qt::ShiftModifier, CameraDrag::Orbit},
                            {Qt::LeftButton, Qt::AltModifier, CameraDrag::Pan}};

template <std::size_t N> CameraDrag find(const DragRow (&rows)[N], Qt::MouseButton button, Qt::KeyboardModifiers held) {
    for (const DragRow& row : rows)
        if (row.button == button && (held & row.held) == row.held) return row.drag;
    return CameraDrag::None;
}

} // namespace

CameraDrag cameraDrag(NavigationStyle style, Qt::MouseButton button, Qt::KeyboardModifiers held) {
    switch (style) {
    case NavigationStyle::Blender: return find(kBlender, button, held);
    case NavigationStyle::Cad: return find(kCad, button, held);
    case NavigationStyle::Trundle: break;
    }
    return find(kTrundle, button, held);
}

QString navigationWords(NavigationStyle style) {
    const auto tr = [](const char* text) { return QCoreApplication::translate("NavigationStyle", text); };
    switch (style) {
    case NavigationStyle::Blender:
        return tr("Middle button: orbit. Shift and middle: pan. Ctrl and middle: zoom. The same with Alt and the left button. "
                  "Right button held: W A S D, Q and E fly. Wheel: zoom.");
    case NavigationStyle::Cad:
        return tr("Middle button: pan. Shift and middle: orbit. Ctrl and middle: zoom. Right button: orbit, and while it is held "
                  "W A S D, Q and E fly. Alt and left: pan, with Shift orbit. Wheel: zoom.");
    case NavigationStyle::Trundle: break;
    }
    return tr(
        "Middle or right button: orbit. With Shift: pan. The same with Alt and the left button. Right button held: W A S D, "
        "Q and E fly. Wheel: zoom.");
}

} // namespace trundle
