#pragma once
#include "editor/properties/row_editor.h"

class QCompleter;
class QMenu;
class QStringListModel;
class QToolButton;

namespace trundle {

/// A name of something else: typed with completion, or picked from the list of what fits. Where several names may stand, picking
/// adds one or takes it out.
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
