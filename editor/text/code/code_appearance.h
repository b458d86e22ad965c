#pragma once
// Keys, margins, fonts and colours of the editor widget.

class QsciScintilla;

namespace trundle {

/// The widget keeps only the keys that move the caret or edit single characters; every named command is in the table of actions,
/// and undo belongs to the document.
void chooseKeys(QsciScintilla& edit);
void buildMargins(QsciScintilla& edit);
/// Fonts and colours of the theme.
void applyAppearance(QsciScintilla& edit);

} // namespace trundle
