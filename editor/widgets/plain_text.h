#pragma once
// Text of others (names of files, words of modules, diagnostics) is shown as it is. Qt guesses whether a text is HTML (Qt::AutoText), and
// a file called `<img src=...>` would be shown as a picture, and read one from the disk.

#include <string>

#include <QRect>
#include <QString>

class QApplication;
class QMessageBox;
class QPoint;
class QWidget;

namespace trundle {

/// From now on labels, message boxes and tool tips of the application take no text for HTML, but labels that were told to (setTextFormat)
/// before they are shown. Who does that escapes what is not his own: toHtmlEscaped(). applyTheme() calls it.
void showTextPlainly(QApplication& application);

/// One line without control characters, for a path or a name.
[[nodiscard]] QString shownLine(const std::string& text);

/// For menus, tabs and buttons, which take `&` for the mark of a shortcut's letter.
[[nodiscard]] QString withoutMnemonics(QString text);

/// In place of QToolTip::showText(), which could show it as HTML. It goes when the mouse leaves `room`, where that is given.
void showToolTip(const QPoint& at, const QString& text, QWidget* of, const QRect& room = {});
/// The one way to a tool tip in HTML; the caller has escaped what is in it.
void showHtmlToolTip(const QPoint& at, const QString& html, QWidget* of, const QRect& room = {});
/// The second text of a message box in HTML; the caller has escaped what is in it.
void setHtmlInformation(QMessageBox& box, const QString& html);

} // namespace trundle
