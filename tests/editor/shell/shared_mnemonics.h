#pragma once
// Finds Alt-letters that several widgets of a dialog have: only one of them would answer.

#include <map>

#include <QAbstractButton>
#include <QGroupBox>
#include <QKeySequence>
#include <QLabel>

namespace trundle {

/// Also of widgets that are hidden for now.
inline QStringList sharedMnemonics(const QWidget& dialog) {
    std::map<QString, QStringList> byLetter;
    const auto add = [&](const QString& text) {
        if (const QKeySequence letter = QKeySequence::mnemonic(text); !letter.isEmpty()) byLetter[letter.toString()] << text;
    };
    for (const auto* label : dialog.findChildren<QLabel*>())
        if (label->buddy()) add(label->text());
    for (const auto* button : dialog.findChildren<QAbstractButton*>()) add(button->text());
    for (const auto* group : dialog.findChildren<QGroupBox*>()) add(group->title());
    QStringList shared;
    for (const auto& [letter, texts] : byLetter)
        if (texts.size() > 1) shared << QStringLiteral("%1 is that of %2").arg(letter, texts.join(QStringLiteral(" and ")));
    return shared;
}

} // namespace trundle
