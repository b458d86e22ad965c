#include "editor/outline/library_model.h"

#include <algorithm>

#include <QMimeData>

#include "editor/outline/block_mime.h"

namespace trundle {
namespace {

/// The help of a config may begin with its title, "EvBot: a sturdy robot".
QString titleAndHelp(const LibraryItem& item, const QString& between) {
    if (item.help.startsWith(item.title + QStringLiteral(": "))) return item.help;
    return item.help.isEmpty() ? item.title : item.title + between + item.help;
}

} // namespace

LibraryModel::LibraryModel(TextOf textOf, QObject* parent) : QAbstractListModel(parent), m_textOf(std::move(textOf)) {}

void LibraryModel::setItems(std::vector<LibraryItem> items) {
    std::stable_sort(items.begin(), items.end(),
                     [](const LibraryItem& a, const LibraryItem& b) { return a.section < b.section; });
    if (items == m_items) return;
    beginResetModel();
    m_items = std::move(items);
    endResetModel();
}

void LibraryModel::setPicture(const std::string& experiment, const QImage& picture) {
    m_pictures.insert(QString::fromStdString(experiment), QPixmap::fromImage(picture)); // null while it is being rendered
    for (std::size_t i = 0; i < m_items.size(); ++i)
        if (m_items[i].picture == experiment) Q_EMIT dataChanged(index(int(i)), index(int(i)), {PictureRole});
}

QVariant LibraryModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || std::size_t(index.row()) >= m_items.size()) return {};
    const LibraryItem& item = m_items[std::size_t(index.row())];
    switch (role) {
    case Qt::DisplayRole: return item.title;
    case Qt::ToolTipRole: return titleAndHelp(item, QStringLiteral("\n"));
    case Qt::StatusTipRole: return titleAndHelp(item, QStringLiteral(": "));
    case Qt::AccessibleDescriptionRole:
    case HelpRole: return item.help;
    case SectionRole: return int(item.section);
    case IconRole: return item.icon;
    case PictureRole: {
        const auto it = item.picture.empty() ? m_pictures.end() : m_pictures.find(QString::fromStdString(item.picture));
        return it == m_pictures.end() || it->isNull() ? QVariant() : QVariant(*it);
    }
    default: return {};
    }
}

Qt::ItemFlags LibraryModel::flags(const QModelIndex& index) const {
    return index.isValid() ? Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsDragEnabled : Qt::ItemFlags();
}

QStringList LibraryModel::mimeTypes() const { return {QLatin1String(kLibraryMime)}; }

QMimeData* LibraryModel::mimeData(const QModelIndexList& indexes) const {
    if (indexes.isEmpty() || std::size_t(indexes.front().row()) >= m_items.size()) return nullptr;
    const LibraryItem& item = m_items[std::size_t(indexes.front().row())];
    const std::string text = textOf(item);
    return text.empty() ? nullptr : libraryMime(item, text);
}

} // namespace trundle
