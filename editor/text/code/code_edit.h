#pragma once
// The editor widget for one text. It preserves all bytes, valid UTF-8 or not; a BOM is hidden. All offsets are byte offsets in the
// file. It has no undo history of its own. Its parts: colours and folds, line wrapping, places on the screen, the mouse, marks.

#include <functional>
#include <optional>

#include "editor/text/code/code_marks.h"
#include "editor/text/code/code_pointer.h"
#include "editor/text/code/code_wrapping.h"
#include "editor/text/code/line_edits.h"

namespace trundle {

class CodeEdit final : public QsciScintilla {
    Q_OBJECT
public:
    explicit CodeEdit(QWidget* parent = nullptr);

    [[nodiscard]] std::string bytes() const { return m_text.bytes(); }
    [[nodiscard]] bool shows(std::string_view bytes) const { return m_text.is(bytes); }
    void load(std::string_view bytes); ///< replaces the text; caret at the start
    /// Updates the text after an external change: caret, selection, scroll position and folds keep their positions in it.
    /// Returns the end of the last change.
    std::uint32_t bring(std::string_view bytes);
    /// Sets the file's line end and indentation step.
    void setWays(const std::string& lineEnd, const std::string& step);
    /// Plain, for large texts: no colours, folds or line wrapping, so that the widget stores no style per byte. Clears the text then.
    void setLanguage(CodeLanguage language, bool plain);

    [[nodiscard]] std::uint32_t caret() const { return m_text.offset(m_text.caret()); }
    [[nodiscard]] TextRange selection() const { return m_text.selection(); }
    void select(TextRange range, bool scroll = true);              ///< caret at its end; unfolds the lines around it
    [[nodiscard]] bool isComposing() const { return m_composing; } ///< an input method shows preedit text

    /// Replaces a range, reported like typing.
    void type(TextRange range, std::string_view text, std::uint32_t caretAfter);
    void removeForward(); ///< deletes the selection, else the next character
    /// Applies a command of line_edits.h, which gets the text, the anchor and the caret.
    void changeLines(const std::function<std::optional<LineEdit>(std::string_view, std::size_t, std::size_t)>& command);
    [[nodiscard]] const std::string& lineEnd() const { return m_lineEnd; }

    [[nodiscard]] CodeStyling& styling() { return m_styling; }
    [[nodiscard]] CodeWrapping& wrapping() { return m_wrapping; }
    [[nodiscard]] CodeGeometry& geometry() { return m_geometry; }
    [[nodiscard]] CodePointer& pointer() { return m_pointer; }
    [[nodiscard]] CodeMarks& marks() { return m_marks; }

Q_SIGNALS:
    void actionBegins(); ///< a key press, paste or drop; changes up to the next signal belong to it
    /// The user changed the text, not load() or bring(). One of the two is empty.
    void edited(std::size_t at, std::string_view removed, std::string_view inserted);
    void caretMovedByHand();
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
    void setPlain(bool plain);
    void applyStyle();
    void fitNumberMargin();
    void onModified(int at, int what, const char* text, int length);
    void apply(const LineEdit& edit);
    void updateCaret();
    void rememberCaret();

    CodeText m_text{*this};
    CodeStyling m_styling{*this, m_text};
    CodeGeometry m_geometry{*this, m_text, m_styling};
    CodeWrapping m_wrapping{*this};
    CodePointer m_pointer{m_geometry};
    CodeMarks m_marks{*this, m_text};
    std::string m_lineEnd = "\n", m_step = "  ";
    long m_lastCaret = 0, m_lastAnchor = 0;
    bool m_own = false; ///< load() or bring() is running
    bool m_composing = false;
};

} // namespace trundle
