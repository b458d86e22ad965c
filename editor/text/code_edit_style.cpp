// Keys, margins, colours and marks of CodeEdit.

#include <algorithm>
#include <cmath>

#include <QPainter>

#include "editor/text/code_edit.h"
#include "editor/widgets/theme.h"

namespace trundle {
namespace {

enum Margin { kNumbers = 0, kBlocks = 1, kSymbols = 2, kFolds = 3 };
enum Indicator { kError = 8, kWarning = 9, kHint = 10, kMatch = 11, kBlock = 12, kLink = 13 };
enum Marker { kHintMark = 1, kWarningMark = 2, kErrorMark = 3, kBlockMark = 4 }; // a line shows its highest one

struct Look {
    TextStyle style;
    Ink ink;
    bool bold = false, italic = false;
};
constexpr Look kLooks[] = {
    {TextStyle::Plain, Ink::Text},
    {TextStyle::Kind, Ink::Type, true},
    {TextStyle::Name, Ink::Text, true},
    {TextStyle::Key, Ink::Text},
    {TextStyle::Keyword, Ink::Keyword},
    {TextStyle::Number, Ink::Number},
    {TextStyle::Unit, Ink::Number, false, true},
    {TextStyle::Word, Ink::String},
    {TextStyle::String, Ink::String},
    {TextStyle::Param, Ink::Keyword},
    {TextStyle::Comment, Ink::Comment, false, true},
    {TextStyle::Directive, Ink::Keyword, true},
    {TextStyle::Path, Ink::String},
    {TextStyle::Mark, Ink::Faint},
    {TextStyle::Wrong, Ink::Error},
};

QColor mixed(const QColor& a, const QColor& b, double share) {
    const auto part = [&](int x, int y) { return static_cast<int>(x * (1 - share) + y * share); };
    return {part(a.red(), b.red()), part(a.green(), b.green()), part(a.blue(), b.blue())};
}

int indicatorOf(Severity severity) {
    return severity == Severity::Error ? kError : severity == Severity::Warning ? kWarning : kHint;
}
int markerOf(Severity severity) {
    return severity == Severity::Error ? kErrorMark : severity == Severity::Warning ? kWarningMark : kHintMark;
}

} // namespace

/// The widget keeps only the keys that move the caret or edit single characters; every named command is in the table of actions,
/// and undo belongs to the document.
void CodeEdit::chooseKeys() {
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
        if (QsciCommand* command = standardCommands()->find(which)) {
            command->setKey(0);
            command->setAlternateKey(0);
        }
    }
}

void CodeEdit::buildMargins() {
    setMarginType(kNumbers, NumberMargin);
    setMarginType(kSymbols, SymbolMargin);
    setMarginMarkerMask(kSymbols, 1 << kErrorMark | 1 << kWarningMark | 1 << kHintMark);
    setMarginSensitivity(kSymbols, false);
    setMarginType(kBlocks, SymbolMargin);
    setMarginMarkerMask(kBlocks, 1 << kBlockMark);
    setMarginSensitivity(kBlocks, false);
    setMarginWidth(kBlocks, 3);
    setFolding(BoxedTreeFoldStyle, kFolds);
    setWrapIndentMode(WrapIndentIndented);
    setMarginWidth(kSymbols, 14);
    setMarginWidth(kFolds, 16);
    SendScintilla(SCI_SETMARGINLEFT, 0UL, 4L);
    SendScintilla(SCI_MARKERDEFINE, static_cast<unsigned long>(kBlockMark), static_cast<long>(SC_MARK_FULLRECT));
    for (const int marker : {SC_MARKNUM_FOLDERSUB, SC_MARKNUM_FOLDERTAIL, SC_MARKNUM_FOLDERMIDTAIL})
        SendScintilla(SCI_MARKERDEFINE, static_cast<unsigned long>(marker), static_cast<long>(SC_MARK_EMPTY));
}

void CodeEdit::fitNumberMargin() {
    const int digits = std::max(2, static_cast<int>(QString::number(lines()).size()));
    setMarginWidth(kNumbers, QString(digits + 1, QLatin1Char('9')));
    fitWrap();
}

void CodeEdit::setWrapLines(WrapLines wrap) {
    m_wrap = wrap;
    fitWrap();
}

void CodeEdit::fitWrap() {
    constexpr int kNarrow = 80; // columns
    int room = viewport()->width();
    for (const int margin : {kNumbers, kBlocks, kSymbols, kFolds}) room -= marginWidth(margin);
    const bool narrow = room < kNarrow * SendScintilla(SCI_TEXTWIDTH, static_cast<unsigned long>(STYLE_DEFAULT), "9");
    const bool wraps = !m_plain && (m_wrap == WrapLines::Always || (m_wrap == WrapLines::InNarrowPanes && narrow));
    if (wraps == m_wraps) return;
    m_wraps = wraps;
    setWrapMode(wraps ? WrapWhitespace : WrapNone);
    Q_EMIT wrapsLinesChanged();
}

void CodeEdit::applyStyle() {
    const QColor base = palette().color(QPalette::Base), text = ink(Ink::Text), accent = ink(Ink::Accent);
    const QFont font = monospaceFont();
    const qreal points = font.pointSizeF() > 0 ? font.pointSizeF() : font.pixelSize() * 72.0 / std::max(1, logicalDpiY());
    const QByteArray family = font.family().toUtf8();
    const auto styleFont = [&](int style) {
        SendScintilla(SCI_STYLESETFONT, static_cast<unsigned long>(style), family.constData());
        SendScintilla(SCI_STYLESETSIZEFRACTIONAL, static_cast<unsigned long>(style),
                      static_cast<long>(points * static_cast<int>(SC_FONT_SIZE_MULTIPLIER)));
    };
    styleFont(STYLE_DEFAULT);
    SendScintilla(SCI_STYLESETFORE, static_cast<unsigned long>(STYLE_DEFAULT), text);
    SendScintilla(SCI_STYLESETBACK, static_cast<unsigned long>(STYLE_DEFAULT), base);
    SendScintilla(SCI_STYLECLEARALL);
    setColor(text);
    setPaper(base);
    for (const Look& look : kLooks) {
        const auto style = static_cast<unsigned long>(look.style);
        styleFont(static_cast<int>(look.style));
        SendScintilla(SCI_STYLESETFORE, style, ink(look.ink));
        SendScintilla(SCI_STYLESETBACK, style, base);
        SendScintilla(SCI_STYLESETBOLD, style, static_cast<long>(look.bold));
        SendScintilla(SCI_STYLESETITALIC, style, static_cast<long>(look.italic));
    }
    setExtraAscent(1);
    setExtraDescent(1);
    SendScintilla(SCI_STYLESETFORE, static_cast<unsigned long>(STYLE_LINENUMBER), ink(Ink::Faint));
    SendScintilla(SCI_STYLESETBACK, static_cast<unsigned long>(STYLE_LINENUMBER), palette().color(QPalette::AlternateBase));
    for (const int margin : {kBlocks, kSymbols}) setMarginBackgroundColor(margin, palette().color(QPalette::AlternateBase));
    setFoldMarginColors(base, base);
    applyCaretStyle();
    applyIndicatorStyles();
    SendScintilla(SCI_MARKERSETBACK, static_cast<unsigned long>(kBlockMark), accent);
    drawMarks();
    fitNumberMargin();
}

/// Colours of braces, caret and selection.
void CodeEdit::applyCaretStyle() {
    const QColor base = palette().color(QPalette::Base), text = ink(Ink::Text), accent = ink(Ink::Accent);
    setMatchedBraceForegroundColor(accent);
    setMatchedBraceBackgroundColor(mixed(base, accent, 0.18));
    setUnmatchedBraceForegroundColor(ink(Ink::Error));
    setUnmatchedBraceBackgroundColor(base);
    setCaretForegroundColor(text);
    setCaretWidth(2);
    setCaretLineVisible(true);
    setCaretLineBackgroundColor(mixed(base, text, 0.05));
    setSelectionBackgroundColor(mixed(base, accent, 0.30));
    resetSelectionForegroundColor();
    SendScintilla(SCI_SETSELFORE, 0UL, 0L);
}

void CodeEdit::applyIndicatorStyles() {
    const QColor accent = ink(Ink::Accent);
    const auto indicator = [&](int number, int style, const QColor& colour, int alpha, int outline, bool under) {
        const auto n = static_cast<unsigned long>(number);
        SendScintilla(SCI_INDICSETSTYLE, n, static_cast<long>(style));
        SendScintilla(SCI_INDICSETFORE, n, colour);
        SendScintilla(SCI_INDICSETALPHA, n, static_cast<long>(alpha));
        SendScintilla(SCI_INDICSETOUTLINEALPHA, n, static_cast<long>(outline));
        SendScintilla(SCI_INDICSETUNDER, n, static_cast<long>(under));
    };
    indicator(kError, INDIC_SQUIGGLE, ink(Ink::Error), 255, 255, true);
    indicator(kWarning, INDIC_SQUIGGLE, ink(Ink::Warning), 255, 255, true);
    indicator(kHint, INDIC_DOTS, ink(Ink::Hint), 255, 255, true);
    indicator(kMatch, INDIC_ROUNDBOX, ink(Ink::Warning), 60, 140, true);
    indicator(kBlock, INDIC_FULLBOX, accent, 26, 26, true);
    indicator(kLink, INDIC_PLAIN, accent, 255, 255, true);
}

/// Draws dots and chevrons of the margins as images, because the widget's own shapes are not antialiased.
void CodeEdit::drawMarks() {
    constexpr int kSide = 12;
    const qreal scale = devicePixelRatioF();
    const auto define = [&](int marker, const auto& paint) {
        QImage image(QSize(kSide, kSide) * scale, QImage::Format_ARGB32_Premultiplied);
        image.setDevicePixelRatio(scale);
        image.fill(Qt::transparent);
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.translate(kSide / 2.0, kSide / 2.0);
        paint(painter);
        painter.end();
        SendScintilla(SCI_RGBAIMAGESETSCALE, static_cast<unsigned long>(std::lround(100 * scale)));
        markerDefine(image, marker);
    };
    for (const auto& [marker, colour] :
         {std::pair(kErrorMark, Ink::Error), std::pair(kWarningMark, Ink::Warning), std::pair(kHintMark, Ink::Hint)})
        define(marker, [colour = ink(colour)](QPainter& painter) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(colour);
            painter.drawEllipse(QPointF(0, 0), 4.5, 4.5);
        });
    for (const auto& [marker, turn] : {std::pair(SC_MARKNUM_FOLDEROPEN, 90), std::pair(SC_MARKNUM_FOLDEROPENMID, 90),
                                       std::pair(SC_MARKNUM_FOLDER, 0), std::pair(SC_MARKNUM_FOLDEREND, 0)})
        define(marker, [turn = turn](QPainter& painter) {
            painter.rotate(turn);
            painter.setPen(QPen(ink(Ink::Faint), 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
            const QPointF corners[] = {{-2, -4}, {2, 0}, {-2, 4}};
            painter.drawPolyline(corners, 3);
        });
}

void CodeEdit::mark(int indicator, TextRange range) {
    const long from = position(range.begin), to = position(range.end);
    if (from >= to) return;
    SendScintilla(SCI_SETINDICATORCURRENT, static_cast<unsigned long>(indicator));
    SendScintilla(SCI_INDICATORFILLRANGE, static_cast<unsigned long>(from), to - from);
}

void CodeEdit::clearMarks(int indicator) {
    SendScintilla(SCI_SETINDICATORCURRENT, static_cast<unsigned long>(indicator));
    SendScintilla(SCI_INDICATORCLEARRANGE, 0UL, SendScintilla(SCI_GETLENGTH));
}

void CodeEdit::showProblems(const std::vector<Diagnostic>& problems) {
    for (const int indicator : {kError, kWarning, kHint}) clearMarks(indicator);
    for (const int marker : {kErrorMark, kWarningMark, kHintMark})
        SendScintilla(SCI_MARKERDELETEALL, static_cast<unsigned long>(marker));
    for (const Diagnostic& problem : problems) {
        TextRange range = problem.range.range;
        long from = position(range.begin), to = position(range.end);
        if (from >= to) { // the error is an omission: mark the character next to it
            to = SendScintilla(SCI_POSITIONAFTER, static_cast<unsigned long>(from));
            if (to == from || SendScintilla(SCI_GETCHARAT, static_cast<unsigned long>(from)) <= ' ') {
                to = from;
                from = SendScintilla(SCI_POSITIONBEFORE, static_cast<unsigned long>(from));
            }
        }
        mark(indicatorOf(problem.severity), {offset(from), offset(to)});
        const long line = SendScintilla(SCI_LINEFROMPOSITION, static_cast<unsigned long>(position(range.begin)));
        SendScintilla(SCI_MARKERADD, static_cast<unsigned long>(line), static_cast<long>(markerOf(problem.severity)));
    }
}

void CodeEdit::showMatches(const std::vector<TextRange>& matches) {
    clearMarks(kMatch);
    for (const TextRange& match : matches) mark(kMatch, match);
}

void CodeEdit::showBlock(TextRange block) {
    clearMarks(kBlock);
    SendScintilla(SCI_MARKERDELETEALL, static_cast<unsigned long>(kBlockMark));
    if (block.size() == 0 || m_plain) return;
    mark(kBlock, block);
    const auto line = [&](std::uint32_t at) {
        return SendScintilla(SCI_LINEFROMPOSITION, static_cast<unsigned long>(position(at)));
    };
    for (long i = line(block.begin), last = line(block.end); i <= last; ++i)
        SendScintilla(SCI_MARKERADD, static_cast<unsigned long>(i), static_cast<long>(kBlockMark));
}

void CodeEdit::showLink(TextRange link) {
    clearMarks(kLink);
    mark(kLink, link);
    viewport()->setCursor(link.size() > 0 ? Qt::PointingHandCursor : Qt::IBeamCursor);
}

} // namespace trundle
