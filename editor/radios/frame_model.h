#pragma once
#include <bitset>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include <QAbstractTableModel>

#include "run/live_radio.h"

namespace trundle {

/// Which frames are shown.
struct FrameFilter {
    QString from, to;          ///< radios' paths; empty: any
    std::bitset<kFates> fates; ///< none: any
    QString text;              ///< in a name, an address or the payload (as hex or as characters); upper and lower case alike
    bool operator==(const FrameFilter&) const = default;
};

/// The newest frames of a run at their receivers, and which of them are shown.
class FrameModel final : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Time, From, To, For, Channel, Bytes, Power, Rssi, Lqi, Margin, Outcome, Reason, Columns };
    static constexpr std::size_t kMostFrames = 20'000;

    using QAbstractTableModel::QAbstractTableModel;

    /// Radios of another run: all of the one before goes.
    void add(LiveRadio fresh);
    void clear();
    void setFilter(const FrameFilter& filter);
    [[nodiscard]] const FrameFilter& filter() const { return m_filter; }

    [[nodiscard]] std::size_t frameCount() const { return m_records.size(); }
    [[nodiscard]] std::uint64_t forgotten() const { return m_forgotten; } ///< older ones that are gone
    [[nodiscard]] const FrameRecord& record(int row) const { return at(m_shown[std::size_t(row)]); }
    /// Its bytes; nullptr where they are not kept any more.
    [[nodiscard]] const AirFrame* airFrame(const FrameRecord& record) const;
    /// The power that a radio sent with last.
    [[nodiscard]] std::optional<double> lastPower(const QString& path) const;
    [[nodiscard]] const std::vector<RadioDefinition>& radios() const { return *m_radios; } ///< by RadioId
    [[nodiscard]] QString nameOf(RadioId radio) const { return m_names[radio]; }           ///< short
    /// All that is kept, as a RadioLog writes it.
    [[nodiscard]] std::string csv() const;
    [[nodiscard]] std::string csv(const QModelIndexList& rows) const;
    /// All frames that were sent, as a RadioLog with Format=pcap writes them.
    [[nodiscard]] std::string pcap() const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] const FrameRecord& at(std::uint64_t number) const { return m_records[number - m_first]; }
    void setRadios(std::shared_ptr<const std::vector<RadioDefinition>> radios);
    void forgetOldest(std::size_t count);
    [[nodiscard]] bool isShown(const FrameRecord& record) const;
    [[nodiscard]] bool hasText(const FrameRecord& record) const;
    [[nodiscard]] QString addressee(const FrameRecord& record) const;
    [[nodiscard]] QString text(const FrameRecord& record, int column) const;
    void row(const FrameRecord& record, std::string& csv) const;

    std::shared_ptr<const std::vector<RadioDefinition>> m_radios = std::make_shared<std::vector<RadioDefinition>>();
    std::vector<QString> m_names;
    std::deque<FrameRecord> m_records;
    std::deque<AirFrame> m_frames;
    std::uint64_t m_first = 0;         // number of m_records[0]; numbers are never used twice
    std::deque<std::uint64_t> m_shown; // numbers, rising
    std::uint64_t m_forgotten = 0;
    FrameFilter m_filter;
    std::string m_hex; // the filter's text as bytes in hex; empty where it is none
};

/// "robot0" for the only radio of a robot, else its path.
[[nodiscard]] std::vector<QString> shortNames(const std::vector<RadioDefinition>& radios);

} // namespace trundle
