#include "editor/radios/fate_bar.h"

#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>

#include "editor/radios/frame_words.h"

namespace trundle {
namespace {

constexpr int kEdge = 6, kGap = 4;

} // namespace

FateBar::FateBar(QWidget* parent) : QWidget(parent), m_sum(new QLabel(this)), m_air(new QLabel(this)) {
    setObjectName(QStringLiteral("radioFates"));
    m_sum->setObjectName(QStringLiteral("radioSum"));
    m_sum->setToolTip(tr("Data frames since the start of the run, each counted at every other radio of its channel. "
                         "Nothing is lost without a reason: the numbers add up."));
    m_air->setObjectName(QStringLiteral("radioInTheAir"));
    for (QLabel* label : {m_sum, m_air}) label->setForegroundRole(QPalette::PlaceholderText);
    for (std::size_t i = 0; i < kFates; ++i) {
        auto* button = new QToolButton(this);
        button->setObjectName(QStringLiteral("radioFate%1").arg(i));
        button->setCheckable(true);
        button->setAutoRaise(true);
        button->hide();
        connect(button, &QToolButton::toggled, this, &FateBar::chosenChanged);
        m_buttons[i] = button;
    }
    setCounts(0, 0, {});
}

void FateBar::setCounts(std::uint64_t expected, std::uint64_t inTheAir, const std::array<std::uint64_t, kFates>& fates) {
    m_sum->setText(tr("%L1 frames at radios =").arg(expected));
    m_sum->setVisible(expected > 0);
    m_air->setText(tr("+ %L1 in the air").arg(inTheAir));
    m_air->setVisible(inTheAir > 0);
    for (std::size_t i = 0; i < kFates; ++i) {
        const QString words = fateText(Fate(i));
        m_buttons[i]->setText(QStringLiteral("%L1 %2").arg(fates[i]).arg(words));
        m_buttons[i]->setToolTip(m_buttons[i]->isChecked() ? tr("Show the others again") : tr("Show those only: %1").arg(words));
        m_buttons[i]->setVisible(fates[i] > 0 || m_buttons[i]->isChecked());
    }
    updateGeometry();
    arrange(width());
}

std::bitset<kFates> FateBar::chosen() const {
    std::bitset<kFates> chosen;
    for (std::size_t i = 0; i < kFates; ++i) chosen[i] = m_buttons[i]->isChecked();
    return chosen;
}

void FateBar::chooseNone() {
    for (QToolButton* button : m_buttons) {
        const QSignalBlocker quiet(button);
        button->setChecked(false);
    }
    Q_EMIT chosenChanged();
}

/// As many in a row as there is room for. Returns the height that takes.
int FateBar::arrange(int width) const {
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

QSize FateBar::sizeHint() const { return {200, arrange(std::max(width(), 200))}; }
QSize FateBar::minimumSizeHint() const { return {200, arrange(std::max(width(), 200))}; }

void FateBar::resizeEvent(QResizeEvent*) {
    arrange(width());
    updateGeometry();
}

} // namespace trundle
