#pragma once
#include <QLineEdit>

namespace trundle {

/// A line edit for a value. Enter or losing the focus commits the text; Esc restores the previous one. A refused text stays in
/// red until it is corrected or restored.
class ValueField final : public QLineEdit {
    Q_OBJECT
public:
    explicit ValueField(QWidget* parent = nullptr);

    /// Sets the document's value. What is being typed is not replaced; refused text without the focus is, when the value changes.
    void setValue(const QString& text);
    [[nodiscard]] const QString& value() const { return m_value; }
    /// Shown faint after the text: a unit, or the value of a formula.
    void setSuffix(const QString& suffix);
    void setFaint(bool faint);     ///< for a default
    void setMixed(bool mixed);     ///< the selected objects have different values
    void setCompact(bool compact); ///< one of several fields in a row
    void setError(const QString& reason);
    [[nodiscard]] bool refused() const { return !m_reason.isEmpty(); }
    [[nodiscard]] const QString& reason() const { return m_reason; }
    void restore();
    void enter(); ///< as the Enter key
    /// Width in pixels at which the document's value is not elided.
    [[nodiscard]] int wholeWidth() const;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

Q_SIGNALS:
    void entered(const QString& text);
    void stepped(int steps);                    ///< Up and Down keys
    void refusedChanged(const QString& reason); ///< empty: no refusal any more

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void closeList();
    void clearError();
    void colour();
    void placeSuffix();
    [[nodiscard]] QRect textRect() const;
    [[nodiscard]] bool isElided() const; ///< the text is not fully visible, and the field is not being edited

    QString m_value, m_suffix, m_reason;
    bool m_faint = false, m_mixed = false, m_compact = false, m_colouring = false;
};

/// Commits what is typed in the fields of a panel, as losing the focus does. What has been refused stays.
void commitTyped(const QWidget& panel);

} // namespace trundle
