#pragma once
#include "editor/properties/editors/field_editor.h"

class QCompleter;
class QMenu;
class QStringListModel;

namespace trundle {

/// Edits a reference to a named object: typed with completion, or selected from a list. For a list of references, selecting a
/// name adds or removes it; for one of pairs it adds it, and the value is set once each name has its second one.
class ReferenceEditor final : public FieldEditor {
    Q_OBJECT
public:
    explicit ReferenceEditor(QWidget* parent);

protected:
    void refresh() override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fillMenu();
    void pick(const QString& name);
    void pickForPair(const QString& name);
    [[nodiscard]] bool isOfPairs() const;
    [[nodiscard]] QStringList typedNames() const; ///< in the field, which may not be set yet
    [[nodiscard]] QStringList names() const;

    QToolButton* m_button;
    QMenu* m_menu;
    QStringListModel* m_names;
};

} // namespace trundle
