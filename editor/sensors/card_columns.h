#pragma once
#include <vector>

#include <QWidget>

namespace trundle {

/// Widgets in as many columns as fit, each in the column that is shortest so far. They keep their heights.
class CardColumns final : public QWidget {
    Q_OBJECT
public:
    using QWidget::QWidget;
    /// They become children of this widget.
    void setCards(std::vector<QWidget*> cards);
    void arrange(); ///< the height of a card has changed

protected:
    void resizeEvent(QResizeEvent*) override;
    bool event(QEvent* event) override;

private:
    std::vector<QWidget*> m_cards;
};

} // namespace trundle
