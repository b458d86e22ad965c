#pragma once
#include <vector>

#include <QWidget>

#include "run/live_values.h"

class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace trundle {

class Section;

/// The values of one object.
struct LiveGroup {
    QString object; ///< its path, as a heading; empty: none
    std::vector<LiveValue> values;
};

/// What the selected objects measure and do now, below their rows: name, value, unit. A name that has no room beside its numbers stands
/// above them. Columns, lines and height follow from the names and the width alone; new values move nothing.
class LiveTable final : public QWidget {
    Q_OBJECT
public:
    explicit LiveTable(QWidget* parent);

    /// `hint` is shown below the values, or in place of them where there are none.
    void display(const std::vector<LiveGroup>& groups, const QString& hint);
    /// The same objects a moment later; false where these are others, which display() shows.
    [[nodiscard]] bool update(const std::vector<LiveGroup>& groups);
    /// So high at most; further values are scrolled to.
    void setMostHeight(int height);

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Line {
        std::string name;
        std::size_t numbers = 0;
        bool heading = false;
        bool operator==(const Line&) const = default;
    };
    /// Of one value; the same item twice where name and numbers share a line.
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
    QTreeWidget* m_table;
    QLabel* m_hint;
    std::vector<Line> m_lines;
    std::vector<bool> m_stacked;     // of each line: its name stands above its numbers
    std::vector<Row> m_rows;         // of each line that is no heading
    std::vector<LiveGroup> m_groups; // as shown last
    bool m_rebuilding = false;
    int m_mostHeight = 300;
};

} // namespace trundle
