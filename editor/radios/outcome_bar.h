#pragma once
#include <array>
#include <bitset>
#include <cstdint>

#include <QWidget>

#include "radio/radio_trace.h"

class QLabel;
class QToolButton;

namespace trundle {

/// Counts of all frames so far: the total, and a button with the count of each outcome that occurred. Checked buttons select the
/// outcomes to show.
class OutcomeBar final : public QWidget {
    Q_OBJECT
public:
    explicit OutcomeBar(QWidget* parent = nullptr);

    void setCounts(std::uint64_t expected, std::uint64_t inTheAir, const std::array<std::uint64_t, kReceptionOutcomes>& outcomes);
    [[nodiscard]] std::bitset<kReceptionOutcomes> chosen() const;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

Q_SIGNALS:
    void chosenChanged();

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    int arrange(int width) const;

    QLabel *m_sum, *m_air;
    std::array<QToolButton*, kReceptionOutcomes> m_buttons{};
};

} // namespace trundle
