#pragma once
#include <QWidget>

#include "editor/properties/row.h"

class QLabel;

namespace trundle {

class OriginMark;
class RowEditor;
class ScrubLabel;

/// One row: name, editor, and a mark that shows the origin of the value and opens the row's menu.
class PropertyRow final : public QWidget {
    Q_OBJECT
public:
    PropertyRow(const Row& row, EditorKind kind, QWidget* parent);

    void display(const Row& row);
    [[nodiscard]] const Row& row() const { return m_row; }
    [[nodiscard]] RowEditor& editor() const { return *m_editor; }
    /// Why the typed text is refused, or the diagnostic of the value in the text; empty: neither.
    [[nodiscard]] const QString& refusal() const { return m_refusal.isEmpty() ? m_problem : m_refusal; }
    void setLabelWidth(int width);
    /// Shows the current position or rotation in the run; empty: hidden.
    void setNow(const QString& text);
    [[nodiscard]] int wantedLabelWidth() const;

Q_SIGNALS:
    void entered(); ///< the focus or the mouse pointer entered the row
    void refusedChanged();
    void scrubEnded();
    void scrubCancelled();
    void resetRequested();
    void pushRequested();                                  ///< requests to move the override into the config
    void menuRequested(const QPoint& place, QMenu* under); ///< `under`: a menu to add the row's entries to, or null

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    void layOut();
    void connectParts();
    [[nodiscard]] QString problemInText() const;
    void showLabel();
    void showNote();
    void showOverride();
    void watch(QWidget* widget);
    void fieldMenu(class QLineEdit* field, const QPoint& place);

    Row m_row;
    QString m_refusal, m_problem;
    ScrubLabel* m_label;
    RowEditor* m_editor;
    int m_labelWidth = 0; ///< pixels; 0: not aligned yet
    OriginMark* m_mark;
    QLabel *m_now, *m_note, *m_override;
};

} // namespace trundle
