#pragma once
#include <QPointF>
#include <Qt>

class QKeyEvent;
class QPainter;

namespace trundle {

/// A mouse event of a view.
struct Pointer {
    QPointF at; ///< logical pixels from the top left corner
    Qt::MouseButton button = Qt::NoButton;
    Qt::KeyboardModifiers modifiers;
    bool twice = false; ///< a double click
};

/// A mouse tool of a view. The view offers each press to its tools in order; the first one that accepts it receives the mouse
/// events until the button is released or cancel() is called.
class ViewTool {
public:
    virtual ~ViewTool() = default;

    [[nodiscard]] virtual bool press(const Pointer& pointer) = 0;
    virtual void drag(const Pointer&) {}
    virtual void release(const Pointer&) {}
    /// Esc, or the mouse was lost: restores the state before the press.
    virtual void cancel() {}
    /// Called while no button is pressed. True: the mouse is over an element of this tool, and tools behind it are not asked.
    virtual bool hover(const Pointer&) { return false; }
    virtual void leave() {}
    /// While the tool is active: whether keys go to the tool instead of the window's shortcuts.
    [[nodiscard]] virtual bool canHandleKeys() const { return true; }
    /// While no tool is active: whether this key goes to the tool instead of the window's shortcuts and the focus chain.
    [[nodiscard]] virtual bool needsKey(const QKeyEvent&) const { return false; }
    /// True: the key was handled.
    virtual bool key(QKeyEvent&) { return false; }
    /// Paints over the image, in logical pixels.
    virtual void paint(QPainter&) {}
};

} // namespace trundle
