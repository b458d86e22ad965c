#pragma once
#include <QPointF>
#include <Qt>

class QKeyEvent;
class QPainter;

namespace trundle {

/// A mouse event of a view.
struct Pointer {
    QPointF at; ///< logical pixels from the top left
    Qt::MouseButton button = Qt::NoButton;
    Qt::KeyboardModifiers modifiers;
    bool twice = false; ///< a double click
};

/// One way of working in a view with the mouse. A view asks its works in order; the one that takes a press has the mouse until
/// the button is let go or cancel().
class MouseWork {
public:
    virtual ~MouseWork() = default;

    [[nodiscard]] virtual bool press(const Pointer& pointer) = 0;
    virtual void drag(const Pointer&) {}
    virtual void release(const Pointer&) {}
    /// Esc, or the mouse was taken away: all is as before the press.
    virtual void cancel() {}
    /// No button is down. True: the mouse is over something of this work, and what lies behind is not meant.
    virtual bool hover(const Pointer&) { return false; }
    virtual void leave() {}
    /// While it has the mouse: whether keys are its own, and no shortcuts of the window.
    [[nodiscard]] virtual bool takesKeys() const { return true; }
    /// While this work has the mouse. True: the key is used up.
    virtual bool key(QKeyEvent&) { return false; }
    /// Over the picture, in logical pixels.
    virtual void paint(QPainter&) {}
};

} // namespace trundle
