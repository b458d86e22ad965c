#pragma once
#include <string>

#include <QObject>

#include "schema/kind.h"

class QAction;
class QMenu;

namespace trundle {

class Document;
class ObjectEdits;
class Selection;

/// Fills menus with the kinds that can be inserted at the selection. Kinds come from the registry, so those of modules appear
/// without changes here.
class InsertMenu final : public QObject {
    Q_OBJECT
public:
    InsertMenu(Document& document, Selection& selection, ObjectEdits& edits, QObject* parent = nullptr);

    /// Appends the kinds to a menu each time it opens. Actions that it has already are kept.
    void attach(QMenu& menu);
    void fill(QMenu& menu);

private:
    struct Entries;
    void addPlace(QMenu& menu, const std::string& place, const Entries& entries, bool isFarther);
    static QMenu* namedMenu(QMenu& menu, const QString& title, const QString& name); ///< of the menu, not yet in it
    void addObjects(QMenu& menu);
    QAction* addKind(QMenu& menu, const Kind& kind);
    void addParts(QMenu& menu, const std::string& place, const Kind& part);
    void addNewPart(QMenu& menu, const Kind& part, const QString& title, const std::string& place);
    void insertNewPart(const std::string& place);

    Document& m_document;
    Selection& m_selection;
    ObjectEdits& m_edits;
};

} // namespace trundle
