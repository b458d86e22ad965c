#pragma once
#include <QListView>
#include <QSortFilterProxyModel>
#include <QStyledItemDelegate>
#include <QWheelEvent>

#include "editor/outline/library_item.h"

namespace trundle {

/// The items of one section that contain all words of a search.
class LibrarySectionFilter final : public QSortFilterProxyModel {
    Q_OBJECT
public:
    LibrarySectionFilter(LibrarySection section, QObject* parent) : QSortFilterProxyModel(parent), m_section(section) {}
    void setWords(const QStringList& words);

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
    bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

private:
    [[nodiscard]] int rankOf(const QModelIndex& index) const;

    LibrarySection m_section;
    QStringList m_words;
};

/// A title in at most two lines of `width` pixels, split at a blank or before a capital ("Differential", "Drive") and elided where
/// that is not enough.
[[nodiscard]] QStringList libraryTitleLines(const QString& title, const QFontMetrics& metrics, int width);

/// Draws an item: its preview above the name, or next to name and help.
class LibraryDelegate final : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    bool asList = false;
    int titleLines = 1; ///< below a preview

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    [[nodiscard]] int height(const QFontMetrics& metrics) const; ///< of an item

private:
    void paintPicture(QPainter& painter, const QStyleOptionViewItem& option, const QRect& where, const QModelIndex& index) const;
};

/// A list as high as its items: several lists share one scroll area.
class LibraryList final : public QListView {
    Q_OBJECT
public:
    explicit LibraryList(QWidget* parent = nullptr);
    void setAsList(bool list);
    /// Adjusts the height. Call it when the number of items changes.
    void fit();

Q_SIGNALS:
    void leftBehind(int step); ///< keyboard navigation left the list after the last item (1) or before the first (-1)

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void startDrag(Qt::DropActions actions) override;
    void wheelEvent(QWheelEvent* event) override { event->ignore(); } // the scroll area handles it

private:
    [[nodiscard]] int titleLines(int cell) const;
    LibraryDelegate* m_delegate;
};

} // namespace trundle
