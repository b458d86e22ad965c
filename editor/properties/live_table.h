#pragma once
#include <vector>

#include <QWidget>

#include "run/live/live_values.h"

class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace trundle {

class Section;

/// The live values of one object.
struct LiveGroup {
    QString object; ///< its path, shown as a heading; empty: no heading
    std::vector<LiveValue> values;
};

/// The live values of the selected objects, below their property rows: name, value, unit. A name that does not fit next to its
/// numbers is shown above them. The layout depends only on the names and the width, so new values move nothing.
class LiveTable final : public QWidget {
    Q_OBJECT
public:
    explicit LiveTable(QWidget* parent);

    /// `hint` is shown below the values, or instead of them if there are none.
    void display(const std::vector<LiveGroup>& groups, const QString& hint);
    /// Updates the values; false if the objects have changed, in which case the caller must call display().
    [[nodiscard]] bool update(const std::vector<LiveGroup>& groups);
    /// Maximum height in pixels; further values are reached by scrolling.
    void setMostHeight(int height);

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    class Table;
    struct Line {
        std::string name;
        std::size_t numbers = 0;
        bool heading = false;
        bool operator==(const Line&) const = default;
    };
    /// Items of one value; the same item twice if name and numbers share a line.
    struct Row {
        QTreeWidgetItem *name, *value;
    };
    [[nodiscard]] static std::vector<Line> linesOf(const std::vector<LiveGroup>& groups);
    void rebuild();
    void fill();
    [[nodiscard]] std::vector<bool> stacking() const;
    void style();
    void fit();

    Section* m_section;
    Table* m_table;
    QLabel* m_hint;
    std::vector<Line> m_lines;
    std::vector<bool> m_stacked;     // by line: its name is above its numbers
    std::vector<Row> m_rows;         // one per line, without headings
    std::vector<LiveGroup> m_groups; // as shown last
    bool m_rebuilding = false;
    int m_mostHeight = 300;
};

} // namespace trundle
