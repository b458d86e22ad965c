#pragma once
#include "editor/properties/editors/row_editor.h"

class QToolButton;

namespace trundle {

/// Edits the path of a file, relative to the folder of the text that uses it.
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

/// The path that a text in `folder` uses for `file`: relative if the file is below the folder, else relative to one of `roots`,
/// else with "..".
[[nodiscard]] QString relativeName(const QString& file, const QString& folder, const QStringList& roots);

} // namespace trundle
