#include "editor/text/code/code_language.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "editor/text/code/qscintilla.h"

namespace trundle {
namespace {

using Sci = QsciScintillaBase;

// Numbers of lexers and styles: SciLexer.h of Scintilla 3.
constexpr unsigned long kPythonLexer = 2, kCppLexer = 3, kCMakeLexer = 80;

constexpr LanguageStyle kCpp[] = {
    {0, Ink::Text},
    {1, Ink::Comment, false, true},   // block comment
    {2, Ink::Comment, false, true},   // line comment
    {3, Ink::Comment, false, true},   // documentation
    {4, Ink::Number},
    {5, Ink::Keyword},
    {6, Ink::String},
    {7, Ink::String},                 // character
    {9, Ink::Keyword, true},          // preprocessor
    {10, Ink::Faint},                 // operator
    {11, Ink::Text},                  // identifier
    {12, Ink::Error},                 // string without an end
    {15, Ink::Comment, false, true},  // documentation
    {16, Ink::Type},                  // second list of keywords
    {17, Ink::Comment, true, true},   // keyword in documentation
    {18, Ink::Comment, false, true},
    {20, Ink::String},                // raw string
    {23, Ink::Comment, false, true},  // comment in a preprocessor line
    {24, Ink::Comment, false, true},
};
constexpr LanguageStyle kPython[] = {
    {0, Ink::Text},
    {1, Ink::Comment, false, true},
    {2, Ink::Number},
    {3, Ink::String},
    {4, Ink::String},
    {5, Ink::Keyword},
    {6, Ink::String},                 // in three quotes
    {7, Ink::String},
    {8, Ink::Type, true},             // name of a class
    {9, Ink::Text, true},             // name of a function
    {10, Ink::Faint},                 // operator
    {11, Ink::Text},
    {12, Ink::Comment, false, true},
    {13, Ink::Error},                 // string without an end
    {14, Ink::Type},                  // second list of keywords
    {15, Ink::Keyword, true},         // decorator
    {16, Ink::String},
    {17, Ink::String},
    {18, Ink::String},
    {19, Ink::String},
};
constexpr LanguageStyle kCMake[] = {
    {0, Ink::Text},
    {1, Ink::Comment, false, true},
    {2, Ink::String},
    {3, Ink::String},
    {4, Ink::String},
    {5, Ink::Keyword},                // command
    {6, Ink::Type},
    {7, Ink::Keyword},                // variable
    {8, Ink::Text},
    {9, Ink::Keyword},
    {10, Ink::Keyword},
    {11, Ink::Keyword},
    {12, Ink::Keyword},
    {13, Ink::Keyword},
    {14, Ink::Number},
};

constexpr const char* kCppWords =
    "alignas alignof and and_eq asm auto bitand bitor break case catch class co_await co_return co_yield compl concept const "
    "const_cast consteval constexpr constinit continue decltype default delete do dynamic_cast else enum explicit export extern false "
    "final for friend goto if inline mutable namespace new noexcept not not_eq nullptr operator or or_eq override private protected "
    "public register reinterpret_cast requires return sizeof static static_assert static_cast struct switch template this "
    "thread_local throw true try typedef typeid typename union using virtual volatile while xor xor_eq";
constexpr const char* kCppTypes = "bool char char8_t char16_t char32_t double float int long short signed unsigned void wchar_t";
constexpr const char* kPythonWords =
    "False None True and as assert async await break class continue def del elif else except finally for from global if import in is "
    "lambda nonlocal not or pass raise return try while with yield match case";
constexpr const char* kPythonTypes = "self bool bytes dict float int list object set str tuple super print range len";
constexpr const char* kCMakeWords =
    "add_custom_command add_executable add_library cmake_minimum_required else elseif endif endforeach endfunction find_package foreach "
    "function if include install message option project set target_compile_definitions target_compile_options "
    "target_include_directories target_link_libraries trundle_module";

void setLexer(QsciScintilla& edit, unsigned long lexer, const char* words, const char* types) {
    edit.SendScintilla(Sci::SCI_SETLEXER, lexer);
    edit.SendScintilla(Sci::SCI_SETKEYWORDS, 0UL, words);
    edit.SendScintilla(Sci::SCI_SETKEYWORDS, 1UL, types);
    for (const auto& [name, value] : {std::pair("fold", "1"), std::pair("fold.compact", "0"), std::pair("fold.comment", "1")})
        edit.SendScintilla(Sci::SCI_SETPROPERTY, name, value);
    edit.SendScintilla(Sci::SCI_COLOURISE, 0UL, -1L);
}

} // namespace

CodeLanguage languageOf(const std::string& file) {
    const std::filesystem::path path(file);
    const std::string ending = path.extension().string();
    if (path.filename() == "CMakeLists.txt" || ending == ".cmake") return CodeLanguage::CMake;
    if (ending == ".py") return CodeLanguage::Python;
    if (ending == ".sim" || ending == ".txt") return CodeLanguage::Trundle;
    static constexpr std::array kOfCpp{".cpp", ".cc", ".cxx", ".c", ".h", ".hpp", ".hh"};
    return std::ranges::find(kOfCpp, ending) != kOfCpp.end() ? CodeLanguage::Cpp : CodeLanguage::None;
}

std::span<const LanguageStyle> stylesOf(CodeLanguage language) {
    switch (language) {
    case CodeLanguage::Cpp: return kCpp;
    case CodeLanguage::Python: return kPython;
    case CodeLanguage::CMake: return kCMake;
    default: return {};
    }
}

void useLexer(QsciScintilla& edit, CodeLanguage language) {
    switch (language) {
    case CodeLanguage::Cpp: return setLexer(edit, kCppLexer, kCppWords, kCppTypes);
    case CodeLanguage::Python: return setLexer(edit, kPythonLexer, kPythonWords, kPythonTypes);
    case CodeLanguage::CMake: return setLexer(edit, kCMakeLexer, kCMakeWords, "");
    default: edit.SendScintilla(Sci::SCI_SETLEXER, static_cast<unsigned long>(Sci::SCLEX_CONTAINER));
    }
}

const char* lineComment(CodeLanguage language) {
    return language == CodeLanguage::Python || language == CodeLanguage::CMake ? "#" : "//";
}

} // namespace trundle
