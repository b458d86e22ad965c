#pragma once
#include "editor/properties/row_editor.h"

class QToolButton;

namespace trundle {

/// A file, named relative to the text that uses it.
class FileEditor final : public RowEditor {
    Q_OBJECT
public:
    explicit FileEditor(QWidget* parent);
    [[nodiscard]] QWidget* focusField() const override;

protected:
    void refresh() override;

private:
    void choose();
    void set(const QString& path);

    ValueField* m_field;
    QToolButton* m_button;
};

/// `file` as a text in `folder` names it: below the folder, else below one of `roots`, else by way of "..".
[[nodiscard]] QString relativeName(const QString& file, const QString& folder, const QStringList& roots);

} // namespace trundle
