#pragma once
#include <QWidget>

class QToolButton;
class QVBoxLayout;

namespace trundle {

/// A heading that folds the rows below it.
class Section final : public QWidget {
    Q_OBJECT
public:
    Section(const QString& title, bool open, QWidget* parent);
    /// The parent of its rows from their making on: moved there later, Qt would style each of them once more.
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
