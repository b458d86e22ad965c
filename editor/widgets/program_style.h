#pragma once
#include <QProxyStyle>

namespace trundle {

/// Fusion style with Trundle's icons in message boxes. Titles of docks follow the interface font; Qt draws them in the font at the
/// creation of the dock. Also ensures that Enter never presses Discard or another destructive
/// button.
class ProgramStyle final : public QProxyStyle {
    Q_OBJECT
public:
    ProgramStyle();

    QIcon standardIcon(StandardPixmap which, const QStyleOption* option, const QWidget* widget) const override;
    void drawItemText(QPainter* painter, const QRect& rect, int flags, const QPalette& palette, bool enabled, const QString& text,
                      QPalette::ColorRole role) const override;
    void polish(QWidget* widget) override;
    using QProxyStyle::polish;
};

} // namespace trundle
