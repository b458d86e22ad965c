#include "editor/running/panels/controller_dialogs.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "control/python_kinds.h"
#include "editor/widgets/controls.h"

namespace trundle {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("ControllersPanel", text); }

} // namespace

bool askForTrust(const QString& library, const QString& folder, QWidget* parent) {
    QMessageBox box(QMessageBox::Warning, tr("Trust Modules"), tr("May the modules in this folder run?\n\n%1").arg(folder),
                    QMessageBox::NoButton, parent);
    box.setObjectName(QStringLiteral("trustQuestion"));
    const QString danger =
        isPythonModule(library.toStdString())
            ? tr("%1 is a program. It runs with all your rights: it can read and change your files.")
            : tr("%1 is a program. It runs with all your rights: it can read and change your files, and a fault of a "
                 "component in it can end Trundle.");
    box.setInformativeText(
        danger.arg(QFileInfo(library).fileName()) + QLatin1Char(' ') +
        tr("Trust the folder only if you know who made its contents. Modules below it are trusted too, from now on; "
           "Preferences list the trusted folders."));
    if (QFileInfo(library).fileName() == QLatin1String("CMakeLists.txt"))
        box.setInformativeText(
            tr("A build runs the commands in CMakeLists.txt, with all your rights: they can read and change your files. What is built "
               "runs with Trundle. Trust the folder only if you know who made its contents. Folders below it are trusted too, from now "
               "on; Preferences list the trusted folders."));
    QPushButton* trust = box.addButton(tr("Trust This Folder"), QMessageBox::AcceptRole);
    trust->setObjectName(QStringLiteral("trustAccept"));
    box.setDefaultButton(box.addButton(QMessageBox::Cancel));
    box.exec();
    return box.clickedButton() == trust;
}

int chooseController(const std::vector<ControllerChoice>& choices, const std::vector<std::string>& robots, QWidget* parent) {
    QDialog dialog(parent);
    dialog.setObjectName(QStringLiteral("chooseController"));
    dialog.setWindowTitle(tr("Assign Controller"));
    resizeToFont(dialog, {980, 400});
    auto* column = new QVBoxLayout(&dialog);
    const QString who = robots.size() == 1 ? QString::fromStdString(robots[0]) : tr("%1 robots").arg(robots.size());
    column->addWidget(new QLabel(tr("Controller of %1:").arg(who)));
    auto* list = new QTreeWidget;
    list->setObjectName(QStringLiteral("controllerChoices"));
    list->setHeaderLabels({tr("Controller"), tr("What it does"), tr("Module")});
    list->setRootIsDecorated(false);
    list->setUniformRowHeights(true);
    for (const ControllerChoice& choice : choices) {
        const QString help = QString::fromStdString(choice.kind.help);
        auto* item = new QTreeWidgetItem(list, {QString::fromStdString(choice.kind.name), help,
                                                choice.module.empty() ? tr("loaded") : QString::fromStdString(choice.module)});
        item->setToolTip(1, help);
    }
    list->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    list->header()->setStretchLastSection(false);
    list->header()->setSectionResizeMode(1, QHeaderView::Stretch);
    list->header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
    column->addWidget(list, 1);
    if (choices.empty()) column->addWidget(new QLabel(tr("There is none: load a module first.")));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    QPushButton* assign = buttons->addButton(tr("Assign"), QDialogButtonBox::AcceptRole);
    assign->setObjectName(QStringLiteral("assignAccept"));
    assign->setDefault(true);
    assign->setEnabled(!choices.empty());
    column->addWidget(buttons);
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    QObject::connect(list, &QTreeWidget::itemActivated, &dialog, &QDialog::accept);
    if (list->topLevelItemCount() > 0) list->setCurrentItem(list->topLevelItem(0));
    if (dialog.exec() != QDialog::Accepted) return -1;
    return list->indexOfTopLevelItem(list->currentItem());
}

} // namespace trundle
