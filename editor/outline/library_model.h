#pragma once
#include <functional>
#include <vector>

#include <QAbstractListModel>
#include <QHash>
#include <QPixmap>

#include "editor/outline/library_item.h"

namespace trundle {

/// All items of the library, one row each, in the order of its sections.
class LibraryModel final : public QAbstractListModel {
    Q_OBJECT
public:
    enum Role { HelpRole = Qt::UserRole + 1, SectionRole, IconRole, PictureRole };
    /// Returns the blocks that inserting an item would add now.
    using TextOf = std::function<std::string(const LibraryItem&)>;

    explicit LibraryModel(TextOf textOf, QObject* parent = nullptr);

    /// Does nothing if the items are unchanged.
    void setItems(std::vector<LibraryItem> items);
    [[nodiscard]] const std::vector<LibraryItem>& items() const { return m_items; }
    [[nodiscard]] std::string textOf(const LibraryItem& item) const { return m_textOf(item); }
    /// A preview image is identified by the text of the experiment that it shows.
    void setPicture(const std::string& experiment, const QImage& picture);
    [[nodiscard]] bool hasPicture(const std::string& experiment) const {
        return m_pictures.contains(QString::fromStdString(experiment));
    }

    int rowCount(const QModelIndex& parent = {}) const override {
        return parent.isValid() ? 0 : static_cast<int>(m_items.size());
    }
    QVariant data(const QModelIndex& index, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QStringList mimeTypes() const override;
    QMimeData* mimeData(const QModelIndexList& indexes) const override;
    Qt::DropActions supportedDragActions() const override { return Qt::CopyAction; }

private:
    TextOf m_textOf;
    std::vector<LibraryItem> m_items;
    QHash<QString, QPixmap> m_pictures;
};

} // namespace trundle
