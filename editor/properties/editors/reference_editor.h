#pragma once
#include "editor/properties/editors/row_editor.h"

class QCompleter;
class QMenu;
class QStringListModel;
class QToolButton;

namespace trundle {

/// Edits a reference to a named object: typed with completion, or selected from a list. For a list of references, selecting a
/// name adds or removes it.
class ReferenceEditor final : public RowEditor {
    Q_OBJECT
public:
    explicit ReferenceEditor(QWidget* parent);
    [[nodiscard]] QWidget* focusField() const override;

protected:
    void refresh() override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fillMenu();
    void pick(const QString& name);
    [[nodiscard]] QStringList names() const;

    ValueField* m_field;
    QToolButton* m_button;
    QMenu* m_menu;
    QStringListModel* m_names;
};

} // namespace trundle
