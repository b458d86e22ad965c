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

/// Fills menus with the kinds that may be put where the selection is, from the registry: what a module brings is there without
/// a line here.
class InsertMenu final : public QObject {
    Q_OBJECT
public:
    InsertMenu(Document& document, Selection& selection, ObjectEdits& edits, QObject* parent = nullptr);

    /// Keeps the end of a menu filled, anew each time it opens. What stands in it already stays.
    void attach(QMenu& menu);
    void fill(QMenu& menu);

private:
    struct Entries;
    void addPlace(QMenu& menu, const std::string& place, const Entries& entries);
    void addObjects(QMenu& menu);
    QAction* addKind(QMenu& menu, const Kind& kind, const std::string& place);

    Document& m_document;
    Selection& m_selection;
    ObjectEdits& m_edits;
};

} // namespace trundle
