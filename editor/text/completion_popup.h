#pragma once
#include <vector>

#include <QFrame>

#include "editor/text/completion.h"

class QKeyEvent;
class QLabel;
class QTreeWidget;

namespace trundle {

/// The list under the caret, with a line of help for the one that is chosen. Never takes the keyboard.
class CompletionPopup final : public QFrame {
    Q_OBJECT
public:
    explicit CompletionPopup(QWidget* owner);

    /// `place` is below the caret's line, `lineHeight` what to go up to stand above it; both in global pixels.
    void showItems(const std::vector<const Completion*>& items, const QPoint& place, int lineHeight);
    [[nodiscard]] int current() const; ///< index into the items shown last; -1: none
    void step(int by);                 ///< up or down in the list
    [[nodiscard]] int rows() const;    ///< that are seen at once

Q_SIGNALS:
    void clicked();
    void left(); ///< somebody pressed the mouse elsewhere

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void showHelp();
    void fitTo(const QPoint& place, int lineHeight);

    QWidget* m_owner;
    QTreeWidget* m_list;
    QLabel* m_help;
    std::vector<std::string> m_helps;
};

} // namespace trundle
