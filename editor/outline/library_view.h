#pragma once
#include <QListView>
#include <QSortFilterProxyModel>
#include <QStyledItemDelegate>
#include <QWheelEvent>

#include "editor/outline/library_item.h"

namespace trundle {

/// The items of one section in which all words of a search are found.
class LibrarySectionFilter final : public QSortFilterProxyModel {
    Q_OBJECT
public:
    LibrarySectionFilter(LibrarySection section, QObject* parent) : QSortFilterProxyModel(parent), m_section(section) {}
    void setWords(const QStringList& words);

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    LibrarySection m_section;
    QStringList m_words;
};

/// Draws a thing: its picture above its name, or beside name and help.
class LibraryDelegate final : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    bool asList = false;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

private:
    void paintPicture(QPainter& painter, const QStyleOptionViewItem& option, const QRect& where, const QModelIndex& index) const;
};

/// A list as high as its items: several stand above each other in one scroll area.
class LibraryList final : public QListView {
    Q_OBJECT
public:
    explicit LibraryList(QWidget* parent = nullptr);
    void setAsList(bool list);
    /// To be called when the number of items changes.
    void fit();

Q_SIGNALS:
    void leftBehind(int step); ///< the keyboard goes beyond the last item (1) or before the first (-1)

protected:
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void startDrag(Qt::DropActions actions) override;
    void wheelEvent(QWheelEvent* event) override { event->ignore(); } // the area scrolls

private:
    LibraryDelegate* m_delegate;
};

} // namespace trundle
