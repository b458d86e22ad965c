#include "editor/sensors/card_columns.h"

#include <algorithm>

#include <QEvent>

#include "editor/widgets/theme.h"

namespace trundle {
namespace {

constexpr int kCardWidth = 250, kCardGap = 6; // at the default font

} // namespace

void CardColumns::setCards(std::vector<QWidget*> cards) {
    m_cards = std::move(cards);
    for (QWidget* card : m_cards) {
        if (card->parentWidget() != this) card->setParent(this);
        card->show();
    }
    arrange();
}

void CardColumns::arrange() {
    const int columns = std::max(1, (width() - kCardGap) / (scaledToFont(kCardWidth) + kCardGap));
    const int cardWidth = std::max(1, (width() - kCardGap) / columns - kCardGap);
    std::vector<int> bottoms(std::size_t(columns), kCardGap);
    for (QWidget* card : m_cards) {
        const auto column = std::ranges::min_element(bottoms);
        const int height = card->sizeHint().height();
        card->setGeometry(kCardGap + int(column - bottoms.begin()) * (cardWidth + kCardGap), *column, cardWidth, height);
        *column += height + kCardGap;
    }
    setMinimumHeight(*std::ranges::max_element(bottoms));
}

void CardColumns::resizeEvent(QResizeEvent*) { arrange(); }

bool CardColumns::event(QEvent* event) {
    if (event->type() == QEvent::LayoutRequest) arrange(); // a card has another height
    return QWidget::event(event);
}

} // namespace trundle
