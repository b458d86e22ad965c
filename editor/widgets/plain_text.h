#pragma once
// Shows untrusted text (file names, module texts, diagnostics) as plain text. Qt guesses whether a text is HTML (Qt::AutoText);
// a file called `<img src=...>` would be shown as an image and read one from the disk.

#include <string>

#include <QRect>
#include <QString>

class QApplication;
class QMessageBox;
class QPoint;
class QWidget;

namespace trundle {

/// Makes labels, message boxes and tool tips of the application show plain text, except labels with an explicit setTextFormat()
/// before they are shown; these must escape untrusted text with toHtmlEscaped(). Called by applyTheme().
void showTextPlainly(QApplication& application);

/// One line without control characters, for a path or a name.
[[nodiscard]] QString shownLine(const std::string& text);

/// For menus, tabs and buttons, where `&` marks the mnemonic.
[[nodiscard]] QString withoutMnemonics(QString text);

/// Use it instead of QToolTip::showText(), which may show HTML. The tool tip disappears when the mouse leaves `room`, if given.
void showToolTip(const QPoint& at, const QString& text, QWidget* of, const QRect& room = {});
/// Shows an HTML tool tip; the caller must escape untrusted text.
void showHtmlToolTip(const QPoint& at, const QString& html, QWidget* of, const QRect& room = {});
/// Sets the informative text of a message box as HTML; the caller must escape untrusted text.
void setHtmlInformation(QMessageBox& box, const QString& html);

} // namespace trundle
