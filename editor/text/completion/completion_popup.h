#pragma once
#include <vector>

#include <QFrame>

#include "editor/text/completion/completion.h"

class QKeyEvent;
class QLabel;
class QTreeWidget;

namespace trundle {

/// The list below the caret, with the help of the current item. It never takes the focus.
class CompletionPopup final : public QFrame {
    Q_OBJECT
public:
    explicit CompletionPopup(QWidget* owner);

    /// `place`: below the caret's line; `lineHeight`: distance to move up if it must open above; both in global pixels.
    void showItems(const std::vector<const Completion*>& items, const QPoint& place, int lineHeight);
    [[nodiscard]] int current() const; ///< index into the items shown last; -1: none
    void step(int by);                 ///< moves the current item
    [[nodiscard]] int rows() const;    ///< visible at once

Q_SIGNALS:
    void clicked();
    void left(); ///< mouse press outside

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
