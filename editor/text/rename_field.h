#pragma once
#include <QFrame>

class QCheckBox;
class QLabel;
class QLineEdit;

namespace trundle {

/// A line over a name in the text, in which another name is typed: Enter asks for it, Escape or a click elsewhere closes it.
class RenameField final : public QFrame {
    Q_OBJECT
public:
    /// A child of the viewport that shows the text.
    explicit RenameField(QWidget* viewport);

    /// Opens over the text that starts at `topLeft`, with the keyboard and all of `name` selected.
    void open(const QPoint& topLeft, const QString& name);
    /// Offers to rename it also in texts that are not loaded; `tip` lists them.
    void offerOthers(const QString& sentence, const QString& tip);
    [[nodiscard]] bool renamesOthers() const;
    void showError(const QString& sentence); ///< why the name cannot be had; until it is changed

Q_SIGNALS:
    void renameRequested(const QString& name);
    void closed(); ///< by the person: the keyboard goes back to the text

protected:
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fit();

    QLineEdit* m_name;
    QCheckBox* m_others;
    QLabel* m_error;
    QPoint m_at;
};

} // namespace trundle
