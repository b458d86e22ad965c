#pragma once
#include <bitset>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include <QAbstractTableModel>

#include "run/live/live_radio.h"

namespace trundle {

/// Which frames are shown.
struct PacketFilter {
    QString from, to;                         ///< paths of radios; empty: any
    std::bitset<kReceptionOutcomes> outcomes; ///< none: any
    QString text;                             ///< in a name, an address or the payload (as hex or characters); case-insensitive
    bool operator==(const PacketFilter&) const = default;
};

/// The newest frames of a run at their receivers, filtered.
class PacketModel final : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Time, From, To, For, Channel, Bytes, Power, Rssi, Lqi, Margin, Outcome, Reason, Columns };
    static constexpr std::size_t kMaxFrames = 20'000;

    using QAbstractTableModel::QAbstractTableModel;

    /// Adds frames. If the radios are those of another run, the frames of the previous run are removed first.
    void add(LiveRadio fresh);
    void clear();
    void setFilter(const PacketFilter& filter);
    [[nodiscard]] const PacketFilter& filter() const { return m_filter; }

    [[nodiscard]] std::size_t frameCount() const { return m_records.size(); }
    [[nodiscard]] std::uint64_t dropped() const { return m_dropped; } ///< oldest frames dropped so far
    [[nodiscard]] const FrameRecord& record(int row) const { return at(m_shown[std::size_t(row)]); }
    /// The captured frame with its bytes; nullptr if they are no longer stored.
    [[nodiscard]] const AirFrame* capturedFrame(const FrameRecord& record) const;
    /// The transmit power (dBm) that a radio used last.
    [[nodiscard]] std::optional<double> lastPower(const QString& path) const;
    [[nodiscard]] const std::vector<RadioDefinition>& radios() const { return *m_radios; } ///< by RadioId
    [[nodiscard]] QString nameOf(RadioId radio) const { return m_names[radio]; }           ///< short
    /// All stored frames in the format of a RadioLog.
    [[nodiscard]] std::string csv() const;
    [[nodiscard]] std::string csv(const QModelIndexList& rows) const;
    /// All sent frames in the format of a RadioLog with Format=pcap.
    [[nodiscard]] std::string pcap() const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] const FrameRecord& at(std::uint64_t number) const { return m_records[number - m_first]; }
    void setRadios(std::shared_ptr<const std::vector<RadioDefinition>> radios);
    void dropOldest(std::size_t count);
    [[nodiscard]] bool isShown(const FrameRecord& record) const;
    [[nodiscard]] bool hasText(const FrameRecord& record) const;
    [[nodiscard]] QString addressee(const FrameRecord& record) const;
    [[nodiscard]] QString text(const FrameRecord& record, int column) const;
    void row(const FrameRecord& record, std::string& csv) const;

    std::shared_ptr<const std::vector<RadioDefinition>> m_radios = std::make_shared<std::vector<RadioDefinition>>();
    std::vector<QString> m_names;
    std::deque<FrameRecord> m_records;
    std::deque<AirFrame> m_frames;
    std::uint64_t m_first = 0;         // number of m_records[0]; numbers are never reused
    std::deque<std::uint64_t> m_shown; // numbers, ascending
    std::uint64_t m_dropped = 0;
    PacketFilter m_filter;
    std::string m_hex; // the filter's text as hex digits; empty if it is not hex
};

/// "robot0" for the only radio of a robot, else its path.
[[nodiscard]] std::vector<QString> shortNames(const std::vector<RadioDefinition>& radios);

} // namespace trundle
