#include "editor/shell/dialogs/new_module_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "editor/shell/dialogs/result_label.h"

namespace trundle {

NewModuleDialog::NewModuleDialog(Options options, QWidget* parent)
    : QDialog(parent), m_options(std::move(options)), m_name(new QLineEdit), m_folder(new QLineEdit(m_options.project)),
      m_cpp(new QRadioButton(tr("C+&+: built with CMake, fastest"))),
      m_python(new QRadioButton(tr("&Python: a file, without a build"))), m_use(new QCheckBox),
      m_result(new ResultLabel("moduleResult", 3)) {
    setObjectName(QStringLiteral("newModule"));
    setWindowTitle(m_options.isController ? tr("New Controller") : tr("New Component"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_name->setObjectName(QStringLiteral("moduleName"));
    m_name->setPlaceholderText(m_options.isController ? QStringLiteral("WallFollow") : QStringLiteral("Thermometer"));
    m_folder->setObjectName(QStringLiteral("moduleFolder"));
    m_cpp->setObjectName(QStringLiteral("moduleCpp"));
    m_cpp->setChecked(true);
    m_python->setObjectName(QStringLiteral("modulePython"));
    m_use->setObjectName(QStringLiteral("moduleUse"));
    m_use->setText(m_options.isController ? tr("&Use it for %1").arg(m_options.user) : tr("&Load it into the experiment"));
    m_use->setChecked(true);
    m_result->setMinimumWidth(420);
    makeLayout();
    for (QLineEdit* field : {m_name, m_folder}) connect(field, &QLineEdit::textChanged, this, &NewModuleDialog::check);
    connect(m_python, &QRadioButton::toggled, this, &NewModuleDialog::check);
    connect(m_use, &QCheckBox::toggled, this, &NewModuleDialog::check);
    check();
}

void NewModuleDialog::makeLayout() {
    auto* browse = new QToolButton;
    browse->setText(QStringLiteral("…"));
    browse->setToolTip(tr("Choose the folder"));
    auto* where = new QHBoxLayout;
    where->addWidget(m_folder, 1);
    where->addWidget(browse);
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(12);
    form->addRow(tr("&Name"), m_name);
    form->addRow(tr("Language"), m_cpp);
    form->addRow(QString(), m_python);
    auto* folder = new QLabel(tr("&Folder"));
    folder->setBuddy(m_folder);
    form->addRow(folder, where);
    if (!m_options.isController || !m_options.user.isEmpty()) form->addRow(QString(), m_use);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_create = buttons->addButton(tr("Create"), QDialogButtonBox::AcceptRole);
    m_create->setObjectName(QStringLiteral("moduleCreate"));
    m_create->setDefault(true);
    auto* all = new QVBoxLayout(this);
    all->setSpacing(12);
    all->addLayout(form);
    all->addWidget(m_result);
    all->addStretch(1);
    all->addWidget(buttons);
    connect(browse, &QToolButton::clicked, this, &NewModuleDialog::choose);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

ModuleTemplate NewModuleDialog::what() const {
    if (!m_options.isController) return m_python->isChecked() ? ModuleTemplate::PythonComponent : ModuleTemplate::Component;
    return m_python->isChecked() ? ModuleTemplate::PythonController : ModuleTemplate::Controller;
}

std::string NewModuleDialog::kind() const { return m_name->text().trimmed().toStdString(); }

std::string NewModuleDialog::folder() const { return QDir::cleanPath(m_folder->text().trimmed()).toStdString(); }

bool NewModuleDialog::isUsed() const { return m_use->isChecked() && (!m_options.isController || !m_options.user.isEmpty()); }

void NewModuleDialog::choose() {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder of the Module"), m_folder->text());
    if (!folder.isEmpty()) m_folder->setText(folder);
}

QString NewModuleDialog::fault() const {
    const QFileInfo folder(QString::fromStdString(this->folder()));
    const QString real = folder.canonicalFilePath();
    if (!folder.isDir()) return tr("There is no folder %1.").arg(folder.filePath());
    if (real != m_options.project && !real.startsWith(m_options.project + QLatin1Char('/')))
        return tr("The folder must be that of the experiment or one in it: %1.").arg(m_options.project);
    if (const QString named = m_options.fault(what(), kind()); !named.isEmpty()) return named;
    const QString made = folder.filePath() + QLatin1Char('/') + QString::fromStdString(moduleNameFor(kind()));
    return QFileInfo::exists(made) ? tr("%1 exists already.").arg(made) : QString();
}

/// Says what will be written, or why nothing can be.
void NewModuleDialog::check() {
    const bool isEmpty = kind().empty();
    const QString why = isEmpty ? QString() : fault();
    m_create->setEnabled(!isEmpty && why.isEmpty());
    if (isEmpty) return m_result->show(tr("The name is a capital letter, then letters, digits and _."), false);
    if (!why.isEmpty()) return m_result->show(why, true);
    const QString name = QString::fromStdString(moduleNameFor(kind()));
    QString text = m_python->isChecked() ? tr("Writes %1/%1.py.").arg(name) : tr("Writes %1/%1.cpp and %1/CMakeLists.txt.").arg(name);
    if (isUsed() && !m_python->isChecked()) text += QLatin1Char(' ') + tr("They are built at once.");
    m_result->show(
        text + QLatin1Char(' ') + tr("The folder %1 becomes trusted: what is in it may run, with your rights.").arg(name), false);
}

} // namespace trundle
