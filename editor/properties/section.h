#pragma once
#include <QWidget>

class QToolButton;
class QVBoxLayout;

namespace trundle {

/// A heading that collapses the rows below it.
class Section final : public QWidget {
    Q_OBJECT
public:
    Section(const QString& title, bool open, QWidget* parent);
    /// Create the rows with this parent: Qt would style them again if they were reparented.
    [[nodiscard]] QWidget* rows() { return m_rows; }
    void add(QWidget* row);
    void setTitle(const QString& title);

Q_SIGNALS:
    void folded(bool open);

private:
    void fold(bool open);
    QToolButton* m_heading;
    QWidget* m_rows;
    QVBoxLayout* m_layout;
};

} // namespace trundle
