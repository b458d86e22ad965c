#pragma once
#include "editor/properties/editors/field_editor.h"

namespace trundle {

/// Edits the path of a file, relative to the folder of the text that uses it.
class FileEditor final : public FieldEditor {
    Q_OBJECT
public:
    explicit FileEditor(QWidget* parent);

private:
    void choose();
    void set(const QString& path);
};

/// The path that a text in `folder` uses for `file`: relative if the file is below the folder, else relative to one of `roots`,
/// else with "..".
[[nodiscard]] QString relativeName(const QString& file, const QString& folder, const QStringList& roots);

} // namespace trundle
