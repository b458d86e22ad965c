#pragma once
#include <QWidget>

#include "editor/properties/row.h"

class QLabel;

namespace trundle {

class OriginMark;
class RowEditor;
class ScrubLabel;

/// One row: name, editor, and a mark that says where the value comes from and opens the row's menu.
class PropertyRow final : public QWidget {
    Q_OBJECT
public:
    PropertyRow(const Row& row, EditorKind kind, QWidget* parent);

    void display(const Row& row);
    [[nodiscard]] const Row& row() const { return m_row; }
    [[nodiscard]] RowEditor& editor() const { return *m_editor; }
    /// Why what was typed is refused, or what is wrong with what stands in the text; empty: nothing.
    [[nodiscard]] const QString& refusal() const { return m_refusal.isEmpty() ? m_problem : m_refusal; }
    void setLabelWidth(int width);
    /// Where what the row sets stands in the run; empty: no such thing.
    void setNow(const QString& text);
    [[nodiscard]] int labelWidthWanted() const;

Q_SIGNALS:
    void entered(); ///< the focus is in it, or the mouse wants its help
    void refusedChanged();
    void scrubEnded();
    void scrubAbandoned();
    void resetWanted();
    void pushWanted();                                  ///< the override is to go into the config
    void menuWanted(const QPoint& place, QMenu* under); ///< `under`: a menu that the row's entries join, or null

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
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
    int m_labelWidth = 0; ///< 0: not aligned yet
    OriginMark* m_mark;
    QLabel *m_now, *m_note, *m_override;
};

} // namespace trundle
