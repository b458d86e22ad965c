#pragma once
// The rows of what is selected. They come from the schema alone; a change goes through the document and comes back from it.

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

class Document;
class HelpStrip;
class LiveTable;
struct LiveGroup;
class ObjectHeader;
class PropertyRow;
class RunSession;
class Section;
class Selection;

class PropertiesPanel final : public QWidget {
    Q_OBJECT
public:
    /// `session` may be missing: nothing runs then.
    PropertiesPanel(Document& document, Selection& selection, RunSession* session, QWidget* parent = nullptr);

    [[nodiscard]] QSize sizeHint() const override { return {320, 500}; }

Q_SIGNALS:
    void jumpTo(const std::string& file, const trundle::SourceRange& range);

protected:
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    /// What of a row makes its widgets: when it stays the same they stay.
    struct Shape {
        std::string id;
        QString section;
        EditorKind kind;
        std::size_t fields;
        bool operator==(const Shape&) const = default;
    };
    void refresh();
    void followDocument();
    [[nodiscard]] bool isInUse() const;
    void showNothing(const QString& why);
    void dropRows();
    void build(const std::vector<Row>& rows, const std::vector<Shape>& shapes);
    void addRow(const Row& row, EditorKind kind, Section& section);
    void alignLabels();
    void showHelp();
    void showLive();
    void showNow();
    [[nodiscard]] std::vector<LiveGroup> liveGroups() const;
    [[nodiscard]] QString liveHint() const;
    void showFailure(const std::string& id, const Status& status); ///< in the strip of help; nothing where all went well
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
    QScrollArea* m_scroll;
    QWidget* m_body = nullptr; ///< holds the rows
    LiveTable* m_live;
    HelpStrip* m_strip;
    QLabel* m_nothing;
    std::vector<Shape> m_shapes;
    std::vector<PropertyRow*> m_rows;
    std::vector<std::string> m_paths; ///< selected, and shown now
    std::vector<std::string> m_kinds; ///< of those
    QTimer m_gone;                    ///< what is shown has gone, or has another name, or nothing is shown yet
    std::set<std::string> m_asText;   ///< rows that are edited as text
    std::set<QString> m_closed;       ///< sections folded by the user
    std::string m_current;            ///< row whose help is shown
    bool m_stale = false;
};

} // namespace trundle
