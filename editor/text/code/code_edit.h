#pragma once
// The editor widget for one text: syntax colours from the language's own lexer, folding, problem marks. It preserves all bytes,
// valid UTF-8 or not; a BOM is hidden. All offsets are byte offsets in the file. It has no undo history of its own.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "editor/text/code/code_marks.h"
#include "editor/text/code/line_edits.h"
#include "editor/text/code/qscintilla.h"
#include "editor/text/code/token_styles.h"
#include "editor/widgets/preferences.h"

namespace trundle {

class CodeEdit final : public QsciScintilla {
    Q_OBJECT
public:
    explicit CodeEdit(QWidget* parent = nullptr);

    [[nodiscard]] std::string bytes() const;
    void load(std::string_view bytes); ///< replaces the text; caret at the start
    /// Updates the text after an external change: caret, selection, scroll position and folds keep their positions in it.
    /// Returns the end of the last change.
    std::uint32_t bring(std::string_view bytes);
    /// Sets the file's line end and indentation step.
    void setWays(const std::string& lineEnd, const std::string& step);

    /// For large texts: no colours, folds or line wrapping, so that the widget stores no style per byte. Clears the text.
    void setPlain(bool plain);
    [[nodiscard]] bool isPlain() const { return m_plain; } ///< for tests

    void setWrapLines(WrapLines wrap);
    [[nodiscard]] bool wrapsLines() const { return m_wraps; } ///< at the current width

    [[nodiscard]] std::uint32_t caret() const;
    [[nodiscard]] TextRange selection() const;
    void select(TextRange range, bool scroll = true);              ///< caret at its end; unfolds the lines around it
    void scrollTo(TextRange range);                                ///< as little as needed; the caret does not move
    [[nodiscard]] std::uint32_t offsetAt(const QPoint& pos) const; ///< `pos` is in the viewport; kNowhere outside the text
    [[nodiscard]] QPoint placeOf(std::uint32_t offset) const;      ///< below its line, in viewport coordinates
    [[nodiscard]] int lineHeight() const;
    static constexpr std::uint32_t kNowhere = 0xffffffffu;

    [[nodiscard]] bool isComposing() const { return m_composing; } ///< an input method shows preedit text

    /// Replaces a range, reported like typing.
    void type(TextRange range, std::string_view text, std::uint32_t caretAfter);

    [[nodiscard]] CodeMarks& marks() { return m_marks; }

    void removeForward(); ///< deletes the selection, else the next character
    void toggleComment();
    void duplicateLines();
    void moveLines(int direction);
    void foldEverything(bool folded);

    [[nodiscard]] TextStyle styleAt(std::uint32_t offset);

Q_SIGNALS:
    void actionBegins(); ///< a key press, paste or drop; changes up to the next signal belong to it
    /// The user changed the text, not load() or bring(). One of the two is empty.
    void edited(std::size_t at, std::string_view removed, std::string_view inserted);
    void caretMovedByHand();
    void hoverRequested(std::uint32_t offset, const QPoint& globalPos);
    void linkFollowed(std::uint32_t offset);
    void linkRequested(std::uint32_t offset); ///< Ctrl is held over it; kNowhere: no longer
    void menuRequested(const QPoint& globalPos);
    void wrapsLinesChanged();
    void left(); ///< the editor lost the focus

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
    void applyStyle();
    void fitNumberMargin();
    void fitWrap();
    void onModified(int at, int what, const char* text, int length);
    void styleUpTo(int position);
    void readTokens();
    void apply(const LineEdit& edit);
    void updateCaret();
    [[nodiscard]] std::string_view view() const; ///< without the BOM; valid until the next change
    [[nodiscard]] long position(std::uint32_t offset) const;
    [[nodiscard]] std::uint32_t offset(long position) const { return static_cast<std::uint32_t>(position) + m_bom; }

    CodeMarks m_marks{*this};
    std::string m_styles; ///< of the text without the BOM
    std::string m_lineEnd = "\n", m_step = "  ";
    std::uint32_t m_bom = 0; ///< its length in bytes
    long m_lastCaret = 0, m_lastAnchor = 0;
    WrapLines m_wrap = WrapLines::InNarrowPanes;
    bool m_wraps = false;
    bool m_plain = false;
    bool m_stale = true; ///< m_styles must be recomputed
    bool m_own = false;  ///< load() or bring() is running
    bool m_looking = false, m_composing = false;
};

} // namespace trundle
