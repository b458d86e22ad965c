#pragma once
#include <QWidget>

#include "run/live_values.h"

class QLabel;
class QTreeWidget;

namespace trundle {

class Section;

/// What the selected object measures and does now, below its rows: name, value, unit. Its columns and its height are the object's;
/// new values move nothing.
class LiveTable final : public QWidget {
    Q_OBJECT
public:
    explicit LiveTable(QWidget* parent);

    /// `object` is said in the heading; empty: nothing is. `hint` stands in place of values where there are none.
    void display(const std::vector<LiveValue>& values, const QString& object, const QString& hint);
    /// The same object a moment later.
    void update(const std::vector<LiveValue>& values);
    /// So high at most; further values are scrolled to.
    void setMostHeight(int height);

protected:
    void changeEvent(QEvent* event) override;

private:
    void fit();
    [[nodiscard]] int nowWidth(int digit) const;
    void style();

    Section* m_section;
    QTreeWidget* m_table;
    QLabel* m_hint;
    std::vector<std::string> m_names;
    std::vector<std::size_t> m_counts; // of numbers, of each
    int m_mostHeight = 300;
};

} // namespace trundle
