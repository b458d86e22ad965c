#pragma once
#include <functional>
#include <set>
#include <string>

#include <QPersistentModelIndex>
#include <QPoint>
#include <QTreeView>

namespace trundle {

class OutlineModel;

/// The tree view. Restores by key which rows the user has expanded, after edits, undo, filters and changes of mode.
class OutlineView final : public QTreeView {
    Q_OBJECT
public:
    explicit OutlineView(OutlineModel& model, QWidget* parent = nullptr);

    /// Resets to the expansion of a newly opened project.
    void forgetFolds();
    /// Restores the expanded rows; while the model is filtered, expands the ancestors of matches instead.
    void unfold();
    /// Expands the ancestors of a row and scrolls to it.
    void reveal(const QModelIndex& index);
    /// Text in the middle of an empty tree.
    void setEmptyText(const QString& text);
    /// Sets a function that returns rich text to append to an object's tooltip; it may return an empty text.
    void setMoreTip(std::function<QString(const std::string& path)> moreTip) { m_moreTip = std::move(moreTip); }
    /// Updates the visible tooltip, if there is one.
    void renewTip();

Q_SIGNALS:
    void markClicked(const QModelIndex& index); ///< visibility or lock column of a row
    void deleteRequested();
    void renameRequested();

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
    template <class Event> void adjustDropIndicator(Event& event, void (OutlineView::*take)(Event*));
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
    QPoint m_tipPlace;            // global coordinates
    Tip m_tip;                    // as shown last
    std::set<std::string> m_open; // keys of expanded rows, of both modes
    QString m_emptyText;
    bool m_unfolding = false;
};

} // namespace trundle
