#pragma once
// The Properties panel: rows for the selected objects, generated from the schema. Edits go to the document, and its changed()
// updates the rows.

#include <memory>
#include <set>
#include <string>
#include <vector>

#include <QTimer>

#include <QWidget>

#include "base/source_range.h"
#include "editor/properties/row.h"

class QLabel;
class QMenu;
class QScrollArea;
class QVBoxLayout;

namespace trundle {

class ChangeSet;
class Document;
class HelpStrip;
class LiveTable;
struct LiveGroup;
class ObjectDetails;
class ObjectHeader;
class PropertyRow;
class RunSession;
class Section;
class Selection;

class PropertiesPanel final : public QWidget {
    Q_OBJECT
public:
    /// `session` may be null: no live values then.
    PropertiesPanel(Document& document, Selection& selection, RunSession* session, QWidget* parent = nullptr);

    [[nodiscard]] QSize sizeHint() const override { return {320, 500}; }
    /// Depends on the font only: what is selected never makes the window grow.
    [[nodiscard]] QSize minimumSizeHint() const override;

Q_SIGNALS:
    void jumpTo(const std::string& file, const trundle::SourceRange& range);

protected:
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    /// What determines a row's widgets: they are reused if it is unchanged.
    struct Shape {
        std::string id;
        QString section;
        EditorKind kind;
        std::size_t fields;
        bool operator==(const Shape&) const = default;
    };
    void refresh();
    void followDocument(const ChangeSet& changes);
    [[nodiscard]] bool isUnaffected(const ChangeSet& changes) const;
    [[nodiscard]] bool isInUse() const;
    void showNothing(const QString& why);
    void dropRows();
    void build(const std::vector<Row>& rows, const std::vector<Shape>& shapes);
    void addRow(const Row& row, EditorKind kind, Section& section);
    void alignLabels();
    void showHelp();
    void showEnded();
    void showLive();
    void showNow();
    [[nodiscard]] std::vector<LiveGroup> liveGroups() const;
    void showFailure(const std::string& id, const Status& status); ///< shows the error in the help strip; clears it on success
    void openMenu(PropertyRow* row, const QPoint& place, QMenu* under);
    void setAsText(const std::string& id);
    void jump(const SourceRange& place);
    [[nodiscard]] EditorKind kindOf(const Row& row) const;
    [[nodiscard]] PropertyRow* rowOf(const std::string& id) const;
    void focusRow(const std::string& id, const QString& field);

    Document& m_document;
    Selection& m_selection;
    RunSession* m_session;
    ObjectHeader* m_header;
    QLabel* m_ended; ///< why a selected robot has ended
    QScrollArea* m_scroll;
    QWidget* m_body = nullptr; ///< parent of the rows
    ObjectDetails* m_details; ///< below the rows
    LiveTable* m_live;
    HelpStrip* m_strip;
    QLabel* m_nothing;
    std::vector<Shape> m_shapes;
    std::vector<PropertyRow*> m_rows;
    std::vector<std::string> m_paths;             ///< selected objects that are shown
    std::vector<std::string> m_kinds;             ///< kinds of these objects
    QTimer m_gone;                                ///< deferred refresh, see followDocument()
    std::set<std::string> m_asText;               ///< ids of rows edited as text
    std::set<QString> m_closed;                   ///< collapsed sections
    std::string m_current;                        ///< id of the row whose help is shown
    std::shared_ptr<const LoadedProject> m_shown; ///< that the rows are right for
    bool m_stale = false;
};

} // namespace trundle
