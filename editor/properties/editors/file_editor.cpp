#include "editor/properties/editors/file_editor.h"

#include <QDir>
#include <QFileDialog>
#include <QToolButton>

#include "editor/properties/editors/value_field.h"
#include "editor/widgets/resources.h"
#include "editor/widgets/theme.h"
#include "project/objects/value_text.h"

namespace trundle {

QString relativeName(const QString& file, const QString& folder, const QStringList& roots) {
    const QString whole = QFileInfo(file).absoluteFilePath();
    QStringList folders{folder};
    folders += roots;
    for (const QString& root : folders) {
        const QString name = root.isEmpty() ? QString() : QDir(root).relativeFilePath(whole);
        if (!name.isEmpty() && !name.startsWith(QLatin1String("..")) && !QDir::isAbsolutePath(name)) return name;
    }
    return folder.isEmpty() ? whole : QDir(folder).relativeFilePath(whole);
}

FileEditor::FileEditor(QWidget* parent) : FieldEditor(parent) {
    QToolButton* button = addButton(QStringLiteral("browse"), tr("Choose a file"));
    button->setIcon(themedIcon(QStringLiteral("open")));
    button->setIconSize({14, 14});
    button->setFocusPolicy(Qt::TabFocus);
    connect(button, &QToolButton::clicked, this, &FileEditor::choose);
}

void FileEditor::choose() {
    QStringList endings;
    for (const std::string& ending : m_row.property()->choices) endings << QStringLiteral("*.") + QString::fromStdString(ending);
    const QString folder = QString::fromStdString(m_row.folder);
    auto* dialog = new QFileDialog(this, tr("Choose a file for %1").arg(m_row.label), folder);
    dialog->setObjectName(QStringLiteral("fileDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    if (!endings.isEmpty())
        dialog->setNameFilters({tr("Fitting files (%1)").arg(endings.join(QLatin1Char(' '))), tr("All files (*)")});
    connect(dialog, &QFileDialog::fileSelected, this, &FileEditor::set);
    dialog->open();
}

void FileEditor::set(const QString& path) {
    const QStringList roots{QString::fromStdString(m_row.loaded->projectFolder), resourcePath(QString())};
    const std::string name = relativeName(path, QString::fromStdString(m_row.folder), roots).toStdString();
    m_field->setModified(false);
    commit(m_field, [name](const FieldValue& v) { return wordOrQuoted(name, v.given() && v.text.starts_with('"')); });
}

} // namespace trundle
