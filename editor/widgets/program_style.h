#pragma once
#include <QProxyStyle>

namespace trundle {

/// Fusion with the program's own icons in message boxes. It also sees to it that no question has Discard or its like as the button
/// that Enter presses.
class ProgramStyle final : public QProxyStyle {
    Q_OBJECT
public:
    ProgramStyle();

    QIcon standardIcon(StandardPixmap which, const QStyleOption* option, const QWidget* widget) const override;
    void polish(QWidget* widget) override;
    using QProxyStyle::polish;
};

} // namespace trundle
