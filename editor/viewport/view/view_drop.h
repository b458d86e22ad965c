#pragma once
#include <memory>

#include <QPointF>

class QDragEnterEvent;
class QDragMoveEvent;
class QDropEvent;
class QPainter;

namespace trundle {

class LibraryDrop;
class ToolView;

/// Drags over a view, from the Library or of rows of the Scene tree.
class ViewDrop {
public:
    explicit ViewDrop(ToolView& view); ///< must outlive this object
    ~ViewDrop();

    void enter(QDragEnterEvent& event);
    void move(QDragMoveEvent& event);
    void leave();
    void drop(QDropEvent& event);
    void paint(QPainter& painter) const;

private:
    bool accepts(QDropEvent& event) const;

    ToolView& m_view;
    std::unique_ptr<LibraryDrop> m_library; // non-null during a drag from the Library over this view
    QPointF m_at{-1, -1};
    bool m_dropping = false, m_moves = false;
};

} // namespace trundle
