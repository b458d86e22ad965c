#include "editor/properties/editors/file_editor.h"

#include <QDir>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QToolButton>

#include "editor/properties/editors/line_editor.h"
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

FileEditor::FileEditor(QWidget* parent) : RowEditor(parent), m_field(new ValueField(this)), m_button(new QToolButton(this)) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(m_field, 1);
    layout->addWidget(m_button);
    m_field->setObjectName(QStringLiteral("field"));
    m_button->setObjectName(QStringLiteral("browse"));
    m_button->setIcon(themedIcon(QStringLiteral("open")));
    m_button->setIconSize({14, 14});
    m_button->setToolTip(tr("Choose a file"));
    m_button->setAccessibleName(m_button->toolTip());
    m_button->setFocusPolicy(Qt::TabFocus);
    m_button->setFixedHeight(m_field->sizeHint().height());
    setFocusProxy(m_field);
    connect(m_button, &QToolButton::clicked, this, &FileEditor::choose);
    connect(m_field, &ValueField::refusedChanged, this, &RowEditor::refusedChanged);
    connect(m_field, &ValueField::entered, this, [this](const QString& typed) {
        const ParsedValue value = typed.isEmpty() ? ParsedValue() : typedValue(m_row, typed);
        commit(m_field, [value](const FieldValue&) { return value; });
    });
}

QWidget* FileEditor::focusField() const { return m_field; }

void FileEditor::refresh() { showLine(*m_field, m_row); }

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
