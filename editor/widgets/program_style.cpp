#include "editor/widgets/program_style.h"

#include <QDockWidget>
#include <QMessageBox>
#include <QPainter>
#include <QPushButton>
#include <QStyleFactory>

#include "editor/widgets/theme.h"

namespace trundle {
namespace {

bool isDestructive(const QMessageBox& box, QAbstractButton* button) {
    const QMessageBox::ButtonRole role = box.buttonRole(button);
    return role == QMessageBox::DestructiveRole || role == QMessageBox::ResetRole;
}

/// Without a default button Qt takes the first accepting one, else the first one.
void chooseDefault(QMessageBox& box) {
    if (QPushButton* chosen = box.defaultButton(); chosen && !isDestructive(box, chosen)) return;
    QPushButton* best = nullptr;
    for (QAbstractButton* button : box.buttons()) {
        auto* push = qobject_cast<QPushButton*>(button);
        if (!push || isDestructive(box, push)) continue;
        const QMessageBox::ButtonRole role = box.buttonRole(push);
        if (role == QMessageBox::AcceptRole || role == QMessageBox::YesRole) {
            best = push;
            break;
        }
        if (!best) best = push;
    }
    if (best) box.setDefaultButton(best);
}

} // namespace

ProgramStyle::ProgramStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

QIcon ProgramStyle::standardIcon(StandardPixmap which, const QStyleOption* option, const QWidget* widget) const {
    switch (which) {
    case SP_MessageBoxInformation: return inkedIcon(QStringLiteral("message-information"), Ink::Accent);
    case SP_MessageBoxQuestion: return inkedIcon(QStringLiteral("message-question"), Ink::Accent);
    case SP_MessageBoxWarning: return inkedIcon(QStringLiteral("message-warning"), Ink::Warning);
    case SP_MessageBoxCritical: return inkedIcon(QStringLiteral("message-critical"), Ink::Error);
    default: return QProxyStyle::standardIcon(which, option, widget);
    }
}

void ProgramStyle::drawItemText(QPainter* painter, const QRect& rect, int flags, const QPalette& palette, bool enabled,
                                const QString& text, QPalette::ColorRole role) const {
    const auto* dock = dynamic_cast<const QDockWidget*>(painter->device());
    const QFont before = painter->font();
    if (dock) painter->setFont(dock->font());
    QProxyStyle::drawItemText(painter, rect, flags, palette, enabled, text, role);
    if (dock) painter->setFont(before);
}

void ProgramStyle::polish(QWidget* widget) {
    QProxyStyle::polish(widget);
    if (auto* box = qobject_cast<QMessageBox*>(widget)) chooseDefault(*box);
}

} // namespace trundle
