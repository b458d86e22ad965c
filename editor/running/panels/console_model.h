#pragma once
#include <cstdint>
#include <deque>
#include <vector>

#include <QAbstractTableModel>
#include <QSet>
#include <QStringList>

#include "run/live/live_run.h"

namespace trundle {

/// The last 100,000 lines of the console, filtered. Lines are added in batches; the oldest are dropped.
class ConsoleModel final : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Time, Who, Text, Columns };
    static constexpr std::size_t kMaxLines = 100'000;

    using QAbstractTableModel::QAbstractTableModel;

    void append(const std::vector<LiveLine>& lines, quint64 dropped);
    void clear();
    /// Filters by robot, including its devices ("": all; kRunItself: lines without a robot), and by a text, case-insensitively.
    void setFilter(const QString& robot, const QString& text);
    static inline const QString kRunItself = QStringLiteral("\n");

    [[nodiscard]] const QStringList& robots() const { return m_robots; } ///< robots with lines, in the order of their first line
    [[nodiscard]] std::size_t lineCount() const { return m_lines.size(); }
    [[nodiscard]] QString copyText(const QModelIndexList& rows) const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

Q_SIGNALS:
    void robotsChanged();

private:
    struct Line {
        double time = 0;
        QString who, text;
        int severity = 0;
    };
    void add(const LiveLine& line, std::deque<Line>& out);
    void noteRobot(const QString& who);
    void forgetOldest(std::size_t count);
    [[nodiscard]] bool isShown(const Line& line) const;
    [[nodiscard]] const Line& line(int row) const { return m_lines[m_shown[static_cast<std::size_t>(row)] - m_first]; }

    std::deque<Line> m_lines;
    std::uint64_t m_first = 0;         // number of m_lines[0]; numbers are never reused
    std::deque<std::uint64_t> m_shown; // numbers, ascending
    QStringList m_robots;
    QSet<QString> m_known; // the same as m_robots
    QString m_robot, m_text;
};

} // namespace trundle
