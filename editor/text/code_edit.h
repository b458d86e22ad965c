#pragma once
// One text on the screen: colours from the language's own lexer, folding, marks under and beside the text. It holds exactly the
// bytes it was given, whatever they are; a BOM is kept out of sight. All places are bytes of the file. It has no undo of its own.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "editor/text/line_edits.h"
#include "editor/text/qscintilla.h"
#include "editor/text/token_styles.h"
#include "editor/widgets/preferences.h"

namespace trundle {

class CodeEdit final : public QsciScintilla {
    Q_OBJECT
public:
    explicit CodeEdit(QWidget* parent = nullptr);

    [[nodiscard]] std::string bytes() const;
    void load(std::string_view bytes); ///< another text; caret at the start
    /// The same text as somebody else changed it: caret, selection, scroll and folds stay with the text they stood on.
    /// Gives where the last change ends.
    std::uint32_t bring(std::string_view bytes);
    /// The file's own ways: its line end and one level of indent.
    void setWays(const std::string& lineEnd, const std::string& step);

    /// Without colours, folds and wrapped lines, for a large text: the widget keeps no style of each byte then. Empties the text.
    void setPlain(bool plain);
    [[nodiscard]] bool isPlain() const { return m_plain; }

    void setWrapLines(WrapLines wrap);
    [[nodiscard]] bool wrapsLines() const { return m_wraps; } ///< now, with the width that it has

    [[nodiscard]] std::uint32_t caret() const;
    [[nodiscard]] TextRange selection() const;
    void select(TextRange range, bool scroll = true);              ///< caret at its end; unfolds what hides it
    void scrollTo(TextRange range);                                ///< as little as needed, caret untouched
    [[nodiscard]] std::uint32_t offsetAt(const QPoint& pos) const; ///< of the viewport; kNowhere where no text is
    [[nodiscard]] QPoint placeOf(std::uint32_t offset) const;      ///< below its line, in the viewport
    [[nodiscard]] int lineHeight() const;
    static constexpr std::uint32_t kNowhere = 0xffffffffu;

    [[nodiscard]] bool isComposing() const { return m_composing; } ///< an input method shows what it may insert

    /// Replaces bytes as if typed.
    void type(TextRange range, std::string_view text, std::uint32_t caretAfter);

    void showProblems(const std::vector<Diagnostic>& problems); ///< of this text
    void showMatches(const std::vector<TextRange>& matches);
    void showBlock(TextRange block); ///< softly; empty: none
    void showLink(TextRange link);   ///< what Ctrl+click follows

    void removeForward(); ///< what is selected, else the next character
    void toggleComment();
    void duplicateLines();
    void moveLines(int direction);
    void foldEverything(bool folded);

    [[nodiscard]] TextStyle styleAt(std::uint32_t offset);

Q_SIGNALS:
    void actionBegins(); ///< a key press, a paste, a drop: the changes until the next belong together
    /// By the person, not by load() or bring(). Either is empty.
    void edited(std::size_t at, std::string_view removed, std::string_view inserted);
    void caretMovedByHand();
    void hoverAsked(std::uint32_t offset, const QPoint& globalPos);
    void linkFollowed(std::uint32_t offset);
    void linkSought(std::uint32_t offset); ///< Ctrl is held over it; kNowhere: no more
    void menuAsked(const QPoint& globalPos);
    void wrapsLinesChanged();
    void left(); ///< the keyboard is elsewhere now

public Q_SLOTS:
    void cut() override;
    void paste() override;

protected:
    bool viewportEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void inputMethodEvent(QInputMethodEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void changeEvent(QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void chooseKeys();
    void buildMargins();
    void applyLook();
    void drawMarks();
    void fitNumberMargin();
    void fitWrap();
    void onModified(int at, int what, const char* text, int length);
    void styleUpTo(int position);
    void readTokens();
    void carryOut(const LineEdit& edit);
    void noticeCaret();
    [[nodiscard]] std::string_view view() const; ///< without the BOM; good until the next change
    [[nodiscard]] long position(std::uint32_t offset) const;
    [[nodiscard]] std::uint32_t offset(long position) const { return static_cast<std::uint32_t>(position) + m_bom; }
    void mark(int indicator, TextRange range);
    void clearMarks(int indicator);

    std::string m_styles; ///< of the text without the BOM
    std::string m_lineEnd = "\n", m_step = "  ";
    std::uint32_t m_bom = 0; ///< bytes of it that stand before the text
    long m_lastCaret = 0, m_lastAnchor = 0;
    WrapLines m_wrap = WrapLines::InNarrowPanes;
    bool m_wraps = false;
    bool m_plain = false;
    bool m_stale = true; ///< m_styles are of an older text
    bool m_own = false;  ///< load() or bring() at work
    bool m_looking = false, m_composing = false;
};

} // namespace trundle
