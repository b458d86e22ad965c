#pragma once
#include <string>

#include <QObject>
#include <QString>

class QPainter;
class QPointF;
class QSize;

namespace trundle {

/// The short texts that a view shows over its image, and the object under the mouse.
class ViewHints final : public QObject {
    Q_OBJECT
public:
    /// Sets the hovered object, outlined thinly, and the hint beside the cursor; empty: none.
    void setHovered(const std::string& path, const QString& hint);
    [[nodiscard]] const std::string& hovered() const { return m_hovered; }
    /// Sets the hint at the lower edge; empty: none.
    void setHint(const QString& hint);
    [[nodiscard]] const QString& hint() const { return m_hint; }

    /// In a view of this size, with the mouse at `cursor`.
    void paint(QPainter& painter, const QSize& size, const QPointF& cursor) const;

Q_SIGNALS:
    void hoveredChanged();
    void textChanged();

private:
    QString m_hint, m_hoverHint;
    std::string m_hovered;
};

} // namespace trundle
