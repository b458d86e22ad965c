#include "editor/radios/packet_model.h"

#include <algorithm>

#include <QHash>

#include "editor/radios/packet_text.h"
#include "editor/widgets/theme.h"
#include "radio/ieee802154.h"
#include "radio/pcap.h"
#include "run/logs/radio_rows.h"

namespace trundle {
namespace {

/// The hex digits of a typed text: "b1 00" or "b100".
std::string asHex(const QString& text) {
    QString hex = text.toLower();
    hex.remove(u' ');
    const auto isHex = [](QChar c) { return (c >= u'0' && c <= u'9') || (c >= u'a' && c <= u'f'); };
    return hex.size() >= 2 && std::ranges::all_of(hex, isHex) ? hex.toStdString() : std::string();
}

/// Out of range is common and shown faint; a disturbed frame is highlighted.
Ink inkOf(ReceptionOutcome outcome) {
    if (outcome == ReceptionOutcome::Delivered) return Ink::Good;
    return outcome == ReceptionOutcome::NotAddressed || outcome == ReceptionOutcome::TooWeak ||
                   outcome == ReceptionOutcome::Duplicate
               ? Ink::Faint
               : Ink::Warning;
}

} // namespace

std::vector<QString> shortNames(const std::vector<RadioDefinition>& radios) {
    const auto robotOf = [](const QString& path) { return path.left(path.indexOf(u'/')); };
    QHash<QString, int> radiosOf;
    for (const RadioDefinition& radio : radios) ++radiosOf[robotOf(QString::fromStdString(radio.path))];
    std::vector<QString> names;
    for (const RadioDefinition& radio : radios) {
        const QString path = QString::fromStdString(radio.path), robot = robotOf(path);
        names.push_back(radiosOf[robot] == 1 ? robot : path);
    }
    return names;
}

// ---- storage ----

void PacketModel::setRadios(std::shared_ptr<const std::vector<RadioDefinition>> radios) {
    clear();
    m_radios = std::move(radios);
    m_names = shortNames(*m_radios);
}

void PacketModel::add(LiveRadio fresh) {
    if (fresh.radios && fresh.radios != m_radios) setRadios(fresh.radios);
    m_dropped += fresh.droppedRecords;
    if (fresh.records.size() > kMaxFrames) {
        const std::size_t over = fresh.records.size() - kMaxFrames;
        fresh.records.erase(fresh.records.begin(), fresh.records.begin() + std::ptrdiff_t(over));
        m_dropped += over;
    }
    if (m_records.size() + fresh.records.size() > kMaxFrames) dropOldest(m_records.size() + fresh.records.size() - kMaxFrames);
    for (AirFrame& frame : fresh.frames) m_frames.push_back(std::move(frame));
    if (m_frames.size() > kMaxFrames)
        m_frames.erase(m_frames.begin(), m_frames.begin() + std::ptrdiff_t(m_frames.size() - kMaxFrames));

    std::vector<std::uint64_t> shown;
    for (std::size_t i = 0; i < fresh.records.size(); ++i)
        if (isShown(fresh.records[i])) shown.push_back(m_first + m_records.size() + i);
    const int row = rowCount();
    if (!shown.empty()) beginInsertRows({}, row, row + int(shown.size()) - 1);
    m_records.insert(m_records.end(), fresh.records.begin(), fresh.records.end());
    m_shown.insert(m_shown.end(), shown.begin(), shown.end());
    if (!shown.empty()) endInsertRows();
}

void PacketModel::dropOldest(std::size_t count) {
    const std::uint64_t first = m_first + count;
    const auto end = std::ranges::lower_bound(m_shown, first);
    const int rows = int(end - m_shown.begin());
    if (rows > 0) beginRemoveRows({}, 0, rows - 1);
    m_shown.erase(m_shown.begin(), end);
    m_records.erase(m_records.begin(), m_records.begin() + std::ptrdiff_t(count));
    m_first = first;
    m_dropped += count;
    if (rows > 0) endRemoveRows();
}

void PacketModel::clear() {
    beginResetModel();
    m_first += m_records.size();
    m_records.clear();
    m_frames.clear();
    m_shown.clear();
    m_dropped = 0;
    endResetModel();
}

/// Frames are ordered by start time, and a radio sends one at a time.
const AirFrame* PacketModel::capturedFrame(const FrameRecord& record) const {
    auto it = std::ranges::lower_bound(m_frames, record.time, {}, &AirFrame::time);
    for (; it != m_frames.end() && it->time == record.time; ++it)
        if (it->from == record.from) return &*it;
    return nullptr;
}

std::optional<double> PacketModel::lastPower(const QString& path) const {
    const std::string wanted = path.toStdString();
    for (auto it = m_records.rbegin(); it != m_records.rend(); ++it)
        if (!it->ack && radios()[it->from].path == wanted) return it->outputPower;
    return std::nullopt;
}

// ---- filter ----

void PacketModel::setFilter(const PacketFilter& filter) {
    if (filter == m_filter) return;
    beginResetModel();
    m_filter = filter;
    m_hex = asHex(filter.text);
    m_shown.clear();
    for (std::size_t i = 0; i < m_records.size(); ++i)
        if (isShown(m_records[i])) m_shown.push_back(m_first + i);
    endResetModel();
}

bool PacketModel::isShown(const FrameRecord& record) const {
    if (m_filter.outcomes.any() && !m_filter.outcomes[std::size_t(record.outcome)]) return false;
    const auto is = [&](const QString& path, RadioId id) { return path.isEmpty() || path.toStdString() == radios()[id].path; };
    return is(m_filter.from, record.from) && is(m_filter.to, record.to) && (m_filter.text.isEmpty() || hasText(record));
}

bool PacketModel::hasText(const FrameRecord& record) const {
    const auto has = [&](const QString& text) { return text.contains(m_filter.text, Qt::CaseInsensitive); };
    for (const RadioId id : {record.from, record.to})
        if (has(QString::fromStdString(radios()[id].path)) || QString::number(radios()[id].address) == m_filter.text) return true;
    if (has(addressee(record))) return true;
    const AirFrame* frame = capturedFrame(record);
    if (!frame) return false;
    const auto payload = payloadOf(*frame, record.ack);
    if (has(asciiOf(payload))) return true;
    if (m_hex.empty()) return false;
    const std::string hex = hexOf(payload).toStdString();
    for (std::size_t at = hex.find(m_hex); at != std::string::npos; at = hex.find(m_hex, at + 1))
        if (at % 2 == 0) return true; // matches must start at a byte
    return false;
}

// ---- export ----

void PacketModel::row(const FrameRecord& record, std::string& csv) const {
    addRadioRow(record, radios()[record.from], radios()[record.to], csv);
}

std::string PacketModel::csv() const {
    std::string text;
    addRadioHeader(text);
    for (const FrameRecord& record : m_records) row(record, text);
    return text;
}

std::string PacketModel::csv(const QModelIndexList& rows) const {
    std::vector<int> order;
    for (const QModelIndex& index : rows) order.push_back(index.row());
    std::ranges::sort(order);
    std::string text;
    addRadioHeader(text);
    for (const int one : order) row(record(one), text);
    return text;
}

std::string PacketModel::pcap() const {
    std::string bytes;
    beginPcap(bytes);
    for (const AirFrame& frame : m_frames) addToPcap(frame, bytes);
    return bytes;
}

// ---- table ----

int PacketModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int(m_shown.size()); }
int PacketModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : Columns; }

QString PacketModel::addressee(const FrameRecord& record) const {
    if (record.address == kBroadcastAddress) return tr("all");
    for (RadioId id = 0; id < radios().size(); ++id)
        if (radios()[id].address == record.address) return m_names[id];
    return QString::number(record.address);
}

QString PacketModel::text(const FrameRecord& record, int column) const {
    switch (column) {
    case Time: return QString::number(record.time, 'f', 6);
    case From: return nameOf(record.from);
    case To: return nameOf(record.to);
    case For: return addressee(record);
    case Channel: return QString::number(radios()[record.from].channel);
    case Bytes: return record.ack ? tr("ack") : QString::number(record.bytes);
    case Power: return decibelText(record.outputPower);
    case Rssi: return QString::number(record.rssi, 'f', radios()[record.to].rssiStep == 1 ? 0 : 1);
    case Lqi: return QString::number(record.lqi);
    case Margin: return decibelText(record.link.power - radios()[record.to].minReceivePower);
    case Outcome: return outcomeText(record.outcome);
    case Reason: return reasonOf(record, radios()[record.to], addressee(record));
    default: return {};
    }
}

QVariant PacketModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) return {};
    const FrameRecord& r = record(index.row());
    const int column = index.column();
    const bool number = column == Time || (column >= Channel && column <= Margin);
    switch (role) {
    case Qt::DisplayRole: return text(r, column);
    case Qt::ToolTipRole: return column == Reason ? QVariant(text(r, column)) : QVariant();
    case Qt::TextAlignmentRole: return number ? QVariant(int(Qt::AlignRight | Qt::AlignVCenter)) : QVariant();
    case Qt::ForegroundRole:
        if (column == Outcome) return ink(inkOf(r.outcome));
        return column == Time || column == Reason ? QVariant(ink(Ink::Faint)) : QVariant();
    default: return {};
    }
}

QVariant PacketModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= Columns) return {};
    const bool number = section == Time || (section >= Channel && section <= Margin);
    if (role == Qt::TextAlignmentRole) return int((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    struct Heading {
        QString title, help;
    };
    static const Heading headings[Columns] = {{tr("Time, s"), tr("Of its first bit, since the start")},
                                              {tr("From"), tr("The radio that sent it")},
                                              {tr("At"), tr("The receiving radio, whether it received the packet or not")},
                                              {tr("For"), tr("Destination address")},
                                              {tr("Ch"), tr("Channel")},
                                              {tr("Bytes"), tr("Of the payload")},
                                              {tr("Power"), tr("Output power, dBm")},
                                              {tr("RSSI"), tr("Strength as the receiver reads it, dBm")},
                                              {tr("LQI"), tr("Link quality, 110 at best")},
                                              {tr("Margin"), tr("Over the receiver's MinReceivePower, dB")},
                                              {tr("Result"), tr("Result of its reception")},
                                              {tr("Why"), {}}};
    if (role == Qt::DisplayRole) return headings[section].title;
    return role == Qt::ToolTipRole && !headings[section].help.isEmpty() ? QVariant(headings[section].help) : QVariant();
}

} // namespace trundle
