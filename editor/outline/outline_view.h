#pragma once
#include <functional>
#include <set>
#include <string>

#include <QPersistentModelIndex>
#include <QPoint>
#include <QTreeView>

namespace trundle {

class OutlineModel;

/// The tree itself. Remembers by key what the user has unfolded, through edits, undo, filters and changes of mode.
class OutlineView final : public QTreeView {
    Q_OBJECT
public:
    explicit OutlineView(OutlineModel& model, QWidget* parent = nullptr);

    /// Folded as another project is at first.
    void forgetFolds();
    /// Unfolds what was unfolded; while the model is filtered, what leads to matches instead.
    void unfold();
    /// Unfolds what is above a row and scrolls to it.
    void reveal(const QModelIndex& index);
    /// Words in the middle of a tree without rows.
    void setEmptyText(const QString& text);
    /// Gives rich text that stands in an object's tooltip below what is always there; may be empty.
    void setMoreTip(std::function<QString(const std::string& path)> moreTip) { m_moreTip = std::move(moreTip); }
    /// The tooltip that is shown, if one is, says what is true now.
    void renewTip();

Q_SIGNALS:
    void markClicked(const QModelIndex& index); ///< eye or lock of a row
    void deleteWanted();
    void renameWanted();

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    bool viewportEvent(QEvent* event) override;
    void startDrag(Qt::DropActions actions) override;
    void dragMoveEvent(QDragMoveEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void unfoldBelow(const QModelIndex& parent, int& budget);
    void remember(const QModelIndex& index, bool open);
    void rekey(const std::string& from, const std::string& to);
    template <class Event> void takeAsMeant(Event& event, void (OutlineView::*take)(Event*));
    void moveInTree(QDragMoveEvent* event) { QTreeView::dragMoveEvent(event); }
    void dropInTree(QDropEvent* event) { QTreeView::dropEvent(event); }
    [[nodiscard]] bool onMark(QMouseEvent* event, QModelIndex& index) const;

    struct Tip {
        QString text;
        bool isHtml = false;
    };
    [[nodiscard]] Tip tipAt(const QModelIndex& index) const;
    void showTip();

    OutlineModel& m_model;
    std::function<QString(const std::string&)> m_moreTip;
    QPersistentModelIndex m_tipRow;
    QPoint m_tipPlace;            // on the screen
    Tip m_tip;                    // as it was shown last
    std::set<std::string> m_open; // keys, of both modes
    QString m_emptyText;
    bool m_unfolding = false;
};

} // namespace trundle
