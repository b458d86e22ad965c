#include "editor/radios/outcome_bar.h"

#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>

#include "editor/radios/packet_text.h"

namespace trundle {
namespace {

constexpr int kEdge = 6, kGap = 4;

} // namespace

OutcomeBar::OutcomeBar(QWidget* parent) : QWidget(parent), m_sum(new QLabel(this)), m_air(new QLabel(this)) {
    setObjectName(QStringLiteral("radioOutcomes"));
    m_sum->setObjectName(QStringLiteral("radioSum"));
    m_sum->setToolTip(tr("Data frames since the start of the run, each counted at every other radio of its channel. "
                         "The numbers add up."));
    m_air->setObjectName(QStringLiteral("radioInTheAir"));
    for (QLabel* label : {m_sum, m_air}) label->setForegroundRole(QPalette::PlaceholderText);
    for (std::size_t i = 0; i < kReceptionOutcomes; ++i) {
        auto* button = new QToolButton(this);
        button->setObjectName(QStringLiteral("radioOutcome%1").arg(i));
        button->setCheckable(true);
        button->setAutoRaise(true);
        button->hide();
        connect(button, &QToolButton::toggled, this, &OutcomeBar::chosenChanged);
        m_buttons[i] = button;
    }
    setCounts(0, 0, {});
}

void OutcomeBar::setCounts(std::uint64_t expected, std::uint64_t inTheAir,
                           const std::array<std::uint64_t, kReceptionOutcomes>& outcomes) {
    m_sum->setText(tr("%L1 frames at radios =").arg(expected));
    m_sum->setVisible(expected > 0);
    m_air->setText(tr("+ %L1 in the air").arg(inTheAir));
    m_air->setVisible(inTheAir > 0);
    for (std::size_t i = 0; i < kReceptionOutcomes; ++i) {
        const QString words = outcomeText(ReceptionOutcome(i));
        m_buttons[i]->setText(QStringLiteral("%L1 %2").arg(outcomes[i]).arg(words));
        m_buttons[i]->setToolTip(m_buttons[i]->isChecked() ? tr("Show the others again") : tr("Show only: %1").arg(words));
        m_buttons[i]->setVisible(outcomes[i] > 0 || m_buttons[i]->isChecked());
    }
    updateGeometry();
    arrange(width());
}

std::bitset<kReceptionOutcomes> OutcomeBar::chosen() const {
    std::bitset<kReceptionOutcomes> chosen;
    for (std::size_t i = 0; i < kReceptionOutcomes; ++i) chosen[i] = m_buttons[i]->isChecked();
    return chosen;
}

/// Wraps the buttons to the width. Returns the total height.
int OutcomeBar::arrange(int width) const {
    std::vector<QWidget*> parts{m_sum};
    parts.insert(parts.end(), m_buttons.begin(), m_buttons.end());
    parts.push_back(m_air);
    const int high = m_buttons.front()->sizeHint().height();
    int x = kEdge, y = 0;
    bool any = false;
    for (QWidget* part : parts) {
        if (part->isHidden()) continue;
        const QSize size(part->sizeHint().width(), high);
        if (x > kEdge && x + size.width() > width - kEdge) {
            x = kEdge;
            y += high + kGap;
        }
        part->setGeometry(x, y, size.width(), high);
        x += size.width() + kGap;
        any = true;
    }
    return any ? y + high + kGap : 0;
}

QSize OutcomeBar::sizeHint() const { return {200, arrange(std::max(width(), 200))}; }
QSize OutcomeBar::minimumSizeHint() const { return {200, arrange(std::max(width(), 200))}; }

void OutcomeBar::resizeEvent(QResizeEvent*) {
    arrange(width());
    updateGeometry();
}

} // namespace trundle
