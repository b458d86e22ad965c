#pragma once
// The Scene dock: the outline of the open project, its filter, and the operations on objects.

#include <string>
#include <vector>

#include <QList>
#include <QWidget>

#include "base/source_range.h"

class QAction;
class QLineEdit;
class QMenu;
class QToolButton;

namespace trundle {

class ChangeSet;
class Document;
class InsertMenu;
class ObjectEdits;
class OutlineModel;
class OutlineView;
class ObjectMarks;
class RunSession;
class Selection;

class OutlinePanel final : public QWidget {
    Q_OBJECT
public:
    /// All must outlive this object.
    OutlinePanel(Document& document, Selection& selection, ObjectMarks& marks, ObjectEdits& edits, QWidget* parent = nullptr);
    ~OutlinePanel() override;

    /// Shows the live values of this run in the tooltips of rows. The session must outlive this.
    void showValuesOf(const RunSession& session);
    /// Adds an action of the window to the context menu.
    void addToMenu(QAction& action) { m_more.append(&action); }
    void focusFilter();
    /// Opens the name editor of the selected row.
    void renameSelected();
    [[nodiscard]] OutlineModel& model() { return *m_model; }
    [[nodiscard]] OutlineView& tree() { return *m_tree; }
    /// The context menu of the selection. The caller shows and deletes it.
    [[nodiscard]] QMenu* contextMenu();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

Q_SIGNALS:
    /// Requests to show a range of a text; `file` is absolute.
    void jumpTo(const std::string& file, const trundle::TextRange& range);
    void lookThroughRequested(const std::string& path); ///< path of a camera as in the selection

private:
    void build();
    void connectAll();
    void showDocument(const ChangeSet& changes);
    void showSelection();
    void takeSelection();
    void setFilter(const QString& text);
    void goToFirstMatch();
    void setByFile(bool byFile);
    void showModel();
    void jumpFrom(const QModelIndex& index);
    void toggleMark(const QModelIndex& index);
    void editConfig(const std::string& path);
    void say();
    void addObjectActions(QMenu& menu, const std::string& path);
    void addMarkActions(QMenu& menu);
    [[nodiscard]] std::vector<std::string> markable() const; ///< selected objects that can be hidden and locked

    Document& m_document;
    Selection& m_selection;
    ObjectMarks& m_marks;
    ObjectEdits& m_edits;
    InsertMenu* m_insert;
    OutlineModel* m_model;
    OutlineView* m_tree;
    QList<QAction*> m_more;
    QLineEdit* m_filter = nullptr;
    QToolButton *m_byOwner = nullptr, *m_byFile = nullptr, *m_add = nullptr;
    bool m_showing = false; ///< the tree is being updated from document and selection: it emits no selection changes
};

} // namespace trundle
