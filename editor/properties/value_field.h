#pragma once
#include <QLineEdit>

namespace trundle {

/// A line in which a value is typed. Enter or leaving the field enters it; Esc brings the old text back. A text that was refused
/// stays as typed, in red, until it is mended or given up.
class ValueField final : public QLineEdit {
    Q_OBJECT
public:
    explicit ValueField(QWidget* parent = nullptr);

    /// What the document says. Leaves alone what is being typed, as long as the document's value stays the same.
    void setValue(const QString& text);
    [[nodiscard]] const QString& value() const { return m_value; }
    /// Shown faint behind the text: a unit, or what a formula comes to.
    void setSuffix(const QString& suffix);
    void setFaint(bool faint);     ///< a default
    void setMixed(bool mixed);     ///< several objects differ
    void setCompact(bool compact); ///< one of several in a row
    void refuse(const QString& reason);
    [[nodiscard]] bool refused() const { return !m_reason.isEmpty(); }
    [[nodiscard]] const QString& reason() const { return m_reason; }
    void restore();
    /// Width in which the document's value is seen whole.
    [[nodiscard]] int wholeWidth() const;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

Q_SIGNALS:
    void entered(const QString& text);
    void stepped(int steps);                    ///< Up and Down keys
    void refusedChanged(const QString& reason); ///< empty: not refused any more

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void enter();
    void closeList();
    void forgive();
    void colour();
    void placeSuffix();
    [[nodiscard]] QRect textRect() const;
    [[nodiscard]] bool isCut() const; ///< some of the text cannot be seen, and nobody is typing in it

    QString m_value, m_suffix, m_reason;
    bool m_faint = false, m_mixed = false, m_compact = false, m_colouring = false;
};

} // namespace trundle
