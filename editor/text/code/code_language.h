#pragma once
// Programming languages of the texts of a project. Texts of Trundle's own language are styled by its lexer (token_styles.h), those of
// others by QScintilla's.

#include <span>
#include <string>

#include "editor/widgets/theme.h"

class QsciScintilla;

namespace trundle {

enum class CodeLanguage { None, Trundle, Cpp, Python, CMake };

/// By the file's name.
[[nodiscard]] CodeLanguage languageOf(const std::string& file);

/// A style of a widget's lexer and its appearance.
struct LanguageStyle {
    int style;
    Ink ink;
    bool bold = false, italic = false;
};
/// Empty for None and Trundle.
[[nodiscard]] std::span<const LanguageStyle> stylesOf(CodeLanguage language);
/// Makes the widget colour and fold its document by the lexer of the language.
void useLexer(QsciScintilla& edit, CodeLanguage language);
/// What begins a comment that ends with the line.
[[nodiscard]] const char* lineComment(CodeLanguage language);

} // namespace trundle
