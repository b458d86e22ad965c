#pragma once
// Finds texts of a window that are clipped.

#include <cmath>

#include <QComboBox>
#include <QLabel>
#include <QTextDocument>
#include <QToolButton>

namespace trundle {

/// The width of the text: the size hint of a label with fixed width may belong to an earlier font.
inline int widthOfWords(const QLabel& label) {
    if (!Qt::mightBeRichText(label.text())) return label.sizeHint().width();
    QTextDocument words;
    words.setDefaultFont(label.font());
    words.setDocumentMargin(label.margin());
    words.setHtml(label.text());
    return int(std::ceil(words.idealWidth()));
}

/// The texts of a dialog or window that are clipped.
inline QStringList cutOff(const QWidget& dialog) {
    QStringList cut;
    for (const auto* label : dialog.findChildren<QLabel*>()) {
        if (!label->isVisible() || label->text().isEmpty()) continue;
        const int needed = label->wordWrap() ? label->heightForWidth(label->width()) : label->sizeHint().height();
        if (label->height() < needed || (!label->wordWrap() && label->width() < widthOfWords(*label)))
            cut << QStringLiteral("label “%1” %2x%3 of %4x%5")
                       .arg(label->text().left(60))
                       .arg(label->width())
                       .arg(label->height())
                       .arg(widthOfWords(*label))
                       .arg(needed);
    }
    for (const auto* button : dialog.findChildren<QAbstractButton*>()) {
        const auto* tool = qobject_cast<const QToolButton*>(button);
        if (!button->isVisible() || button->text().isEmpty() || (tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly))
            continue;
        if (button->width() < button->minimumSizeHint().width() || button->height() < button->fontMetrics().height())
            cut << QStringLiteral("button “%1”").arg(button->text());
    }
    for (const auto* choice : dialog.findChildren<QComboBox*>())
        if (choice->isVisible() && choice->width() < choice->fontMetrics().horizontalAdvance(choice->currentText()) + 24)
            cut << QStringLiteral("choice “%1”").arg(choice->currentText());
    return cut;
}

} // namespace trundle
