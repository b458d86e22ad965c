#pragma once
// What the mouse asks about the text: a tooltip, a link under Ctrl, the context menu.

#include <QObject>

#include "editor/text/code/code_geometry.h"

class QHelpEvent;
class QMouseEvent;

namespace trundle {

class CodePointer final : public QObject {
    Q_OBJECT
public:
    /// `geometry` must outlive this object.
    explicit CodePointer(const CodeGeometry& geometry) : m_geometry(geometry) {}

    void rested(const QHelpEvent& event);
    void moved(const QMouseEvent& event);
    /// Whether the press is on a link; it then does not move the caret.
    [[nodiscard]] bool isOnLink(const QMouseEvent& press) const;
    void follow(const QMouseEvent& press);

Q_SIGNALS:
    void hoverRequested(std::uint32_t offset, const QPoint& globalPos);
    void linkFollowed(std::uint32_t offset);
    void linkRequested(std::uint32_t offset); ///< Ctrl is held over it; CodeGeometry::kNowhere: no longer
    void menuRequested(const QPoint& globalPos);

private:
    const CodeGeometry& m_geometry;
    bool m_looking = false;
};

} // namespace trundle
