#pragma once
#include <QFrame>

class QCheckBox;
class QLabel;
class QLineEdit;

namespace trundle {

/// A line edit over a name in the text: Enter requests the rename, Escape or a click elsewhere closes it.
class RenameField final : public QFrame {
    Q_OBJECT
public:
    /// A child of the text's viewport.
    explicit RenameField(QWidget* viewport);

    /// Opens over the text that starts at `topLeft`, takes the focus and selects all of `name`.
    void open(const QPoint& topLeft, const QString& name);
    /// Offers to rename also in texts that are not loaded; `tip` lists them.
    void offerOthers(const QString& sentence, const QString& tip);
    [[nodiscard]] bool renamesOthers() const;
    void showError(const QString& sentence); ///< why the name is invalid; shown until it is edited

Q_SIGNALS:
    void renameRequested(const QString& name);
    void closed(); ///< by the user: the focus returns to the text

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
