#pragma once
#include <QProxyStyle>

namespace trundle {

/// Fusion style with Trundle's icons in message boxes. Also ensures that Enter never presses Discard or another destructive
/// button.
class ProgramStyle final : public QProxyStyle {
    Q_OBJECT
public:
    ProgramStyle();

    QIcon standardIcon(StandardPixmap which, const QStyleOption* option, const QWidget* widget) const override;
    void polish(QWidget* widget) override;
    using QProxyStyle::polish;
};

} // namespace trundle
