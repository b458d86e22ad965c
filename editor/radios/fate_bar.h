#pragma once
#include <array>
#include <bitset>
#include <cstdint>

#include <QWidget>

#include "radio/radio_trace.h"

class QLabel;
class QToolButton;

namespace trundle {

/// What became of all frames so far: their sum and a button for each fate that occurred, with its number. Pressed ones are those to be
/// shown.
class FateBar final : public QWidget {
    Q_OBJECT
public:
    explicit FateBar(QWidget* parent = nullptr);

    void setCounts(std::uint64_t expected, std::uint64_t inTheAir, const std::array<std::uint64_t, kFates>& fates);
    [[nodiscard]] std::bitset<kFates> chosen() const;
    void chooseNone();
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

Q_SIGNALS:
    void chosenChanged();

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    int arrange(int width) const;

    QLabel *m_sum, *m_air;
    std::array<QToolButton*, kFates> m_buttons{};
};

} // namespace trundle
