#pragma once
// The Scene dock: the tree of what is open, its filter, and what can be done to objects.

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
    /// All outlive this.
    OutlinePanel(Document& document, Selection& selection, ObjectMarks& marks, ObjectEdits& edits, QWidget* parent = nullptr);
    ~OutlinePanel() override;

    /// Rows say in their tooltips what their objects measure in this run, as long as it lasts. It outlives this.
    void showValuesOf(const RunSession& session);
    /// An action of the window that the menu has too, for what is selected.
    void addToMenu(QAction& action) { m_more.append(&action); }
    void focusFilter();
    /// Opens the line for a new name at the selected row.
    void renameSelected();
    [[nodiscard]] OutlineModel& model() { return *m_model; }
    [[nodiscard]] OutlineView& tree() { return *m_tree; }
    /// What a right click on the selection shows; for the caller to show and delete.
    [[nodiscard]] QMenu* contextMenu();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

Q_SIGNALS:
    /// To a place in a text: absolute path of the file.
    void jumpTo(const std::string& file, const trundle::TextRange& range);
    void lookThroughWanted(const std::string& path); ///< a camera, as the selection names it

private:
    void build();
    void connectAll();
    void showDocument();
    void showSelection();
    void takeSelection();
    void setFilter(const QString& text);
    void goToFirstFound();
    void setByFile(bool byFile);
    void jumpFrom(const QModelIndex& index);
    void toggleMark(const QModelIndex& index);
    void editConfig(const std::string& path);
    void say();
    void addObjectActions(QMenu& menu, const std::string& path);
    void addMarkActions(QMenu& menu);
    [[nodiscard]] std::vector<std::string> markable() const; ///< of what is selected

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
    bool m_showing = false; ///< the tree is being brought in line with document and selection: it says nothing itself
};

} // namespace trundle
