#include "editor/running/panels/console_model.h"

#include <algorithm>

#include <trundle/abi.h>

#include "editor/widgets/theme.h"

namespace trundle {
namespace {

constexpr qsizetype kLongestLine = 4000;

QString timeOf(double seconds) { return QString::number(seconds, 'f', 2); }

QVariant colourOf(int severity) {
    if (severity == TRUNDLE_ERROR) return ink(Ink::Error);
    if (severity == TRUNDLE_WARNING) return ink(Ink::Warning);
    return {};
}

QString robotOf(const QString& who) { return who.left(who.indexOf(u'/')); }

} // namespace

/// A message with line breaks becomes several lines.
void ConsoleModel::add(const LiveLine& line, std::deque<Line>& out) {
    const QString who = QString::fromStdString(line.who);
    QString text = QString::fromStdString(line.text);
    while (text.endsWith(u'\n')) text.chop(1);
    noteRobot(who);
    qsizetype from = 0;
    do {
        const qsizetype end = text.indexOf(u'\n', from);
        const QString part = from == 0 && end < 0 ? text : text.mid(from, end < 0 ? -1 : end - from);
        const bool tooLong = part.size() > kLongestLine;
        out.push_back({line.time, who, tooLong ? part.left(kLongestLine) + QStringLiteral(" …") : part, line.severity});
        from = end < 0 ? text.size() + 1 : end + 1;
    } while (from <= text.size());
}

void ConsoleModel::noteRobot(const QString& who) {
    const QString robot = robotOf(who);
    if (robot.isEmpty() || m_known.contains(robot)) return;
    m_known.insert(robot);
    m_robots.append(robot);
}

bool ConsoleModel::isShown(const Line& line) const {
    if (m_robot == kRunItself ? !line.who.isEmpty() : !m_robot.isEmpty() && robotOf(line.who) != m_robot) return false;
    return m_text.isEmpty() || line.text.contains(m_text, Qt::CaseInsensitive) || line.who.contains(m_text, Qt::CaseInsensitive);
}

void ConsoleModel::forgetOldest(std::size_t count) {
    const std::uint64_t first = m_first + count;
    const auto end = std::ranges::lower_bound(m_shown, first);
    if (const auto rows = static_cast<int>(end - m_shown.begin()); rows > 0) {
        beginRemoveRows({}, 0, rows - 1);
        m_shown.erase(m_shown.begin(), end);
        m_lines.erase(m_lines.begin(), m_lines.begin() + static_cast<std::ptrdiff_t>(count));
        m_first = first;
        endRemoveRows();
        return;
    }
    m_lines.erase(m_lines.begin(), m_lines.begin() + static_cast<std::ptrdiff_t>(count));
    m_first = first;
}

void ConsoleModel::append(const std::vector<LiveLine>& lines, quint64 dropped) {
    std::deque<Line> fresh;
    const qsizetype robots = m_robots.size();
    if (dropped > 0)
        fresh.push_back({lines.empty() ? 0 : lines.front().time,
                         {},
                         tr("… %1 lines were not shown: there were too many at once").arg(dropped),
                         TRUNDLE_WARNING});
    for (const LiveLine& line : lines) add(line, fresh);
    if (fresh.size() > kMaxLines) fresh.erase(fresh.begin(), fresh.end() - static_cast<std::ptrdiff_t>(kMaxLines));
    if (m_lines.size() + fresh.size() > kMaxLines)
        forgetOldest(std::min(m_lines.size(), m_lines.size() + fresh.size() - kMaxLines));

    std::deque<std::uint64_t> shown;
    for (std::size_t i = 0; i < fresh.size(); ++i)
        if (isShown(fresh[i])) shown.push_back(m_first + m_lines.size() + i);
    const int row = rowCount();
    if (!shown.empty()) beginInsertRows({}, row, row + static_cast<int>(shown.size()) - 1);
    m_lines.insert(m_lines.end(), std::make_move_iterator(fresh.begin()), std::make_move_iterator(fresh.end()));
    m_shown.insert(m_shown.end(), shown.begin(), shown.end());
    if (!shown.empty()) endInsertRows();
    if (m_robots.size() != robots) Q_EMIT robotsChanged();
}

void ConsoleModel::clear() {
    beginResetModel();
    m_first += m_lines.size();
    m_lines.clear();
    m_shown.clear();
    m_robots.clear();
    m_known.clear();
    endResetModel();
    Q_EMIT robotsChanged();
}

void ConsoleModel::setFilter(const QString& robot, const QString& text) {
    if (robot == m_robot && text == m_text) return;
    beginResetModel();
    m_robot = robot;
    m_text = text;
    m_shown.clear();
    for (std::size_t i = 0; i < m_lines.size(); ++i)
        if (isShown(m_lines[i])) m_shown.push_back(m_first + i);
    endResetModel();
}

QString ConsoleModel::copyText(const QModelIndexList& rows) const {
    std::vector<int> order;
    for (const QModelIndex& index : rows) order.push_back(index.row());
    std::ranges::sort(order);
    QStringList out;
    for (const int row : order) {
        const Line& l = line(row);
        out.append(QStringLiteral("[%1%2] %3").arg(timeOf(l.time), l.who.isEmpty() ? QString() : u' ' + l.who, l.text));
    }
    return out.join(u'\n');
}

int ConsoleModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : static_cast<int>(m_shown.size()); }
int ConsoleModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : Columns; }

QVariant ConsoleModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) return {};
    const Line& l = line(index.row());
    switch (role) {
    case Qt::DisplayRole:
        return index.column() == Time ? QVariant(timeOf(l.time)) : index.column() == Who ? QVariant(l.who) : QVariant(l.text);
    case Qt::ToolTipRole: return index.column() == Text ? QVariant(l.text) : QVariant();
    case Qt::ForegroundRole:
        if (const QVariant colour = colourOf(l.severity); colour.isValid() && index.column() == Text) return colour;
        return index.column() == Text ? QVariant() : QVariant(ink(Ink::Faint));
    case Qt::TextAlignmentRole: return index.column() == Time ? QVariant(int(Qt::AlignRight | Qt::AlignVCenter)) : QVariant();
    default: return {};
    }
}

QVariant ConsoleModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    if (role == Qt::TextAlignmentRole) return int((section == Time ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    if (role != Qt::DisplayRole) return {};
    return section == Time ? tr("Time, s") : section == Who ? tr("Robot") : tr("Text");
}

} // namespace trundle
