#include "editor/text/code/code_appearance.h"

#include <algorithm>
#include <cmath>

#include <QPainter>

#include "editor/text/code/code_marks.h"
#include "editor/text/code/qscintilla.h"
#include "editor/text/code/token_styles.h"
#include "editor/widgets/theme.h"

namespace trundle {
namespace {

using Sci = QsciScintillaBase;

constexpr LanguageStyle kLooks[] = {
    {static_cast<int>(TextStyle::Plain), Ink::Text},
    {static_cast<int>(TextStyle::Kind), Ink::Type, true},
    {static_cast<int>(TextStyle::Name), Ink::Text, true},
    {static_cast<int>(TextStyle::Key), Ink::Text},
    {static_cast<int>(TextStyle::Keyword), Ink::Keyword},
    {static_cast<int>(TextStyle::Number), Ink::Number},
    {static_cast<int>(TextStyle::Unit), Ink::Number, false, true},
    {static_cast<int>(TextStyle::Word), Ink::String},
    {static_cast<int>(TextStyle::String), Ink::String},
    {static_cast<int>(TextStyle::Param), Ink::Keyword},
    {static_cast<int>(TextStyle::Comment), Ink::Comment, false, true},
    {static_cast<int>(TextStyle::Directive), Ink::Keyword, true},
    {static_cast<int>(TextStyle::Path), Ink::String},
    {static_cast<int>(TextStyle::Mark), Ink::Faint},
    {static_cast<int>(TextStyle::Wrong), Ink::Error},
};

QColor mixed(const QColor& a, const QColor& b, double share) {
    const auto part = [&](int x, int y) { return static_cast<int>(x * (1 - share) + y * share); };
    return {part(a.red(), b.red()), part(a.green(), b.green()), part(a.blue(), b.blue())};
}

/// Draws dots and chevrons of the margins as images, because the widget's own shapes are not antialiased.
void drawMarks(QsciScintilla& edit) {
    constexpr int kSide = 12;
    const qreal scale = edit.devicePixelRatioF();
    const auto define = [&](int marker, const auto& paint) {
        QImage image(QSize(kSide, kSide) * scale, QImage::Format_ARGB32_Premultiplied);
        image.setDevicePixelRatio(scale);
        image.fill(Qt::transparent);
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.translate(kSide / 2.0, kSide / 2.0);
        paint(painter);
        painter.end();
        edit.SendScintilla(Sci::SCI_RGBAIMAGESETSCALE, static_cast<unsigned long>(std::lround(100 * scale)));
        edit.markerDefine(image, marker);
    };
    for (const auto& [marker, colour] :
         {std::pair(kErrorMark, Ink::Error), std::pair(kWarningMark, Ink::Warning), std::pair(kHintMark, Ink::Hint)})
        define(marker, [colour = ink(colour)](QPainter& painter) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(colour);
            painter.drawEllipse(QPointF(0, 0), 4.5, 4.5);
        });
    for (const auto& [marker, turn] : {std::pair(Sci::SC_MARKNUM_FOLDEROPEN, 90), std::pair(Sci::SC_MARKNUM_FOLDEROPENMID, 90),
                                       std::pair(Sci::SC_MARKNUM_FOLDER, 0), std::pair(Sci::SC_MARKNUM_FOLDEREND, 0)})
        define(marker, [turn = turn](QPainter& painter) {
            painter.rotate(turn);
            painter.setPen(QPen(ink(Ink::Faint), 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
            const QPointF corners[] = {{-2, -4}, {2, 0}, {-2, 4}};
            painter.drawPolyline(corners, 3);
        });
}

/// Colours of braces, caret and selection.
void applyCaretStyle(QsciScintilla& edit) {
    const QColor base = edit.palette().color(QPalette::Base), text = ink(Ink::Text), accent = ink(Ink::Accent);
    edit.setMatchedBraceForegroundColor(accent);
    edit.setMatchedBraceBackgroundColor(mixed(base, accent, 0.18));
    edit.setUnmatchedBraceForegroundColor(ink(Ink::Error));
    edit.setUnmatchedBraceBackgroundColor(base);
    edit.setCaretForegroundColor(text);
    edit.setCaretWidth(2);
    edit.setCaretLineVisible(true);
    edit.setCaretLineBackgroundColor(mixed(base, text, 0.05));
    edit.setSelectionBackgroundColor(mixed(base, accent, 0.30));
    edit.resetSelectionForegroundColor();
    edit.SendScintilla(Sci::SCI_SETSELFORE, 0UL, 0L);
}

void applyIndicatorStyles(QsciScintilla& edit) {
    const QColor accent = ink(Ink::Accent);
    const auto indicator = [&](int number, int style, const QColor& colour, int alpha, int outline, bool under) {
        const auto n = static_cast<unsigned long>(number);
        edit.SendScintilla(Sci::SCI_INDICSETSTYLE, n, static_cast<long>(style));
        edit.SendScintilla(Sci::SCI_INDICSETFORE, n, colour);
        edit.SendScintilla(Sci::SCI_INDICSETALPHA, n, static_cast<long>(alpha));
        edit.SendScintilla(Sci::SCI_INDICSETOUTLINEALPHA, n, static_cast<long>(outline));
        edit.SendScintilla(Sci::SCI_INDICSETUNDER, n, static_cast<long>(under));
    };
    indicator(kErrorRange, Sci::INDIC_SQUIGGLE, ink(Ink::Error), 255, 255, true);
    indicator(kWarningRange, Sci::INDIC_SQUIGGLE, ink(Ink::Warning), 255, 255, true);
    indicator(kHintRange, Sci::INDIC_DOTS, ink(Ink::Hint), 255, 255, true);
    indicator(kMatchRange, Sci::INDIC_ROUNDBOX, ink(Ink::Warning), 60, 140, true);
    indicator(kBlockRange, Sci::INDIC_FULLBOX, accent, 26, 26, true);
    indicator(kLinkRange, Sci::INDIC_PLAIN, accent, 255, 255, true);
}

} // namespace

void chooseKeys(QsciScintilla& edit) {
    static constexpr QsciCommand::Command kUnwanted[] = {QsciCommand::Undo,
                                                         QsciCommand::Redo,
                                                         QsciCommand::LineDelete,
                                                         QsciCommand::LineCut,
                                                         QsciCommand::LineCopy,
                                                         QsciCommand::LineTranspose,
                                                         QsciCommand::LineDuplicate,
                                                         QsciCommand::SelectionDuplicate,
                                                         QsciCommand::SelectionLowerCase,
                                                         QsciCommand::SelectionUpperCase,
                                                         QsciCommand::MoveSelectedLinesUp,
                                                         QsciCommand::MoveSelectedLinesDown,
                                                         QsciCommand::Formfeed,
                                                         QsciCommand::Newline,
                                                         QsciCommand::ReverseLines,
                                                         QsciCommand::Cancel,
                                                         QsciCommand::ZoomIn,
                                                         QsciCommand::ZoomOut,
                                                         QsciCommand::ParaDown,
                                                         QsciCommand::ParaUp,
                                                         QsciCommand::WordPartLeft,
                                                         QsciCommand::WordPartRight,
                                                         QsciCommand::DeleteLineRight,
                                                         QsciCommand::DeleteLineLeft,
                                                         QsciCommand::VerticalCentreCaret,
                                                         QsciCommand::ScrollToStart,
                                                         QsciCommand::ScrollToEnd,
                                                         QsciCommand::StutteredPageUp,
                                                         QsciCommand::StutteredPageDown};
    for (const QsciCommand::Command which : kUnwanted) {
        if (QsciCommand* command = edit.standardCommands()->find(which)) {
            command->setKey(0);
            command->setAlternateKey(0);
        }
    }
}

void buildMargins(QsciScintilla& edit) {
    edit.setMarginType(kNumberMargin, QsciScintilla::NumberMargin);
    edit.setMarginType(kSymbolMargin, QsciScintilla::SymbolMargin);
    edit.setMarginMarkerMask(kSymbolMargin, 1 << kErrorMark | 1 << kWarningMark | 1 << kHintMark);
    edit.setMarginSensitivity(kSymbolMargin, false);
    edit.setMarginType(kBlockMargin, QsciScintilla::SymbolMargin);
    edit.setMarginMarkerMask(kBlockMargin, 1 << kBlockMark);
    edit.setMarginSensitivity(kBlockMargin, false);
    edit.setMarginWidth(kBlockMargin, 3);
    edit.setFolding(QsciScintilla::BoxedTreeFoldStyle, kFoldMargin);
    edit.setWrapIndentMode(QsciScintilla::WrapIndentIndented);
    edit.setMarginWidth(kSymbolMargin, 14);
    edit.setMarginWidth(kFoldMargin, 16);
    edit.SendScintilla(Sci::SCI_SETMARGINLEFT, 0UL, 4L);
    edit.SendScintilla(Sci::SCI_MARKERDEFINE, static_cast<unsigned long>(kBlockMark), static_cast<long>(Sci::SC_MARK_FULLRECT));
    for (const int marker : {Sci::SC_MARKNUM_FOLDERSUB, Sci::SC_MARKNUM_FOLDERTAIL, Sci::SC_MARKNUM_FOLDERMIDTAIL})
        edit.SendScintilla(Sci::SCI_MARKERDEFINE, static_cast<unsigned long>(marker), static_cast<long>(Sci::SC_MARK_EMPTY));
}

void applyAppearance(QsciScintilla& edit, CodeLanguage language) {
    const QColor base = edit.palette().color(QPalette::Base), text = ink(Ink::Text), accent = ink(Ink::Accent);
    const QFont font = monospaceFont();
    const qreal points = font.pointSizeF() > 0 ? font.pointSizeF() : font.pixelSize() * 72.0 / std::max(1, edit.logicalDpiY());
    const QByteArray family = font.family().toUtf8();
    const auto styleFont = [&](int style) {
        edit.SendScintilla(Sci::SCI_STYLESETFONT, static_cast<unsigned long>(style), family.constData());
        edit.SendScintilla(Sci::SCI_STYLESETSIZEFRACTIONAL, static_cast<unsigned long>(style),
                           static_cast<long>(points * static_cast<int>(Sci::SC_FONT_SIZE_MULTIPLIER)));
    };
    styleFont(Sci::STYLE_DEFAULT);
    edit.SendScintilla(Sci::SCI_STYLESETFORE, static_cast<unsigned long>(Sci::STYLE_DEFAULT), text);
    edit.SendScintilla(Sci::SCI_STYLESETBACK, static_cast<unsigned long>(Sci::STYLE_DEFAULT), base);
    edit.SendScintilla(Sci::SCI_STYLECLEARALL);
    edit.setColor(text);
    edit.setPaper(base);
    const std::span<const LanguageStyle> others = stylesOf(language);
    for (const LanguageStyle& look : others.empty() ? std::span<const LanguageStyle>(kLooks) : others) {
        const auto style = static_cast<unsigned long>(look.style);
        styleFont(look.style);
        edit.SendScintilla(Sci::SCI_STYLESETFORE, style, ink(look.ink));
        edit.SendScintilla(Sci::SCI_STYLESETBACK, style, base);
        edit.SendScintilla(Sci::SCI_STYLESETBOLD, style, static_cast<long>(look.bold));
        edit.SendScintilla(Sci::SCI_STYLESETITALIC, style, static_cast<long>(look.italic));
    }
    edit.setExtraAscent(1);
    edit.setExtraDescent(1);
    edit.SendScintilla(Sci::SCI_STYLESETFORE, static_cast<unsigned long>(Sci::STYLE_LINENUMBER), ink(Ink::Faint));
    edit.SendScintilla(Sci::SCI_STYLESETBACK, static_cast<unsigned long>(Sci::STYLE_LINENUMBER),
                       edit.palette().color(QPalette::AlternateBase));
    for (const int margin : {kBlockMargin, kSymbolMargin})
        edit.setMarginBackgroundColor(margin, edit.palette().color(QPalette::AlternateBase));
    edit.setFoldMarginColors(base, base);
    applyCaretStyle(edit);
    applyIndicatorStyles(edit);
    edit.SendScintilla(Sci::SCI_MARKERSETBACK, static_cast<unsigned long>(kBlockMark), accent);
    drawMarks(edit);
}

} // namespace trundle
