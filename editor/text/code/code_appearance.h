#pragma once
// Keys, margins, fonts and colours of the editor widget.

#include "editor/text/code/code_language.h"

class QsciScintilla;

namespace trundle {

/// The widget keeps only the keys that move the caret or edit single characters; every named command is in the table of actions,
/// and undo belongs to the document.
void chooseKeys(QsciScintilla& edit);
void buildMargins(QsciScintilla& edit);
/// Fonts and colours of the theme, for a text in this language.
void applyAppearance(QsciScintilla& edit, CodeLanguage language);

} // namespace trundle
