#include "editor/shell/group_dialog.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "editor/document/document.h"
#include "editor/document/group_edit.h"
#include "editor/widgets/theme.h"
#include "project/edits/plan_group.h"

namespace trundle {
namespace {

QString trGroup(const char* text) { return QCoreApplication::translate("GroupDialog", text); }

} // namespace

void askForGroup(QWidget* parent, Document& document, const std::vector<std::string>& paths, const std::string& shippedConfigs) {
    if (!document.isOpen()) return;
    if (document.isNew() || document.isSample(document.path()))
        return Q_EMIT document.refused(trGroup("A piece is a file beside the experiment: save the experiment first."));
    const std::string name = freeGroupName(*document.loaded(), shippedConfigs);
    if (const auto plan = planGroup(*document.loaded(), paths, name, shippedConfigs); !plan)
        return Q_EMIT document.refused(QString::fromStdString(plan.error().message));

    auto* dialog = new QDialog(parent);
    dialog->setObjectName(QStringLiteral("groupDialog"));
    dialog->setWindowTitle(trGroup("Group into Piece"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    auto* layout = new QVBoxLayout(dialog);
    auto* words = new QLabel(
        paths.size() == 1 ? trGroup("The selected object becomes a piece that can be placed again.")
                          : trGroup("The %1 selected objects become one piece that can be placed again.").arg(paths.size()));
    auto* line = new QLineEdit(QString::fromStdString(name));
    line->setObjectName(QStringLiteral("groupName"));
    line->setAccessibleName(trGroup("Name of the piece"));
    line->selectAll();
    auto* file = new QLabel;
    file->setObjectName(QStringLiteral("groupFile"));
    file->setTextFormat(Qt::PlainText);
    file->setWordWrap(true);
    file->setMinimumWidth(360);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    QPushButton* group = buttons->addButton(trGroup("Group"), QDialogButtonBox::AcceptRole);
    group->setDefault(true);
    for (QWidget* widget :
         {static_cast<QWidget*>(words), static_cast<QWidget*>(line), static_cast<QWidget*>(file), static_cast<QWidget*>(buttons)})
        layout->addWidget(widget);
    const auto planned = [&document, line, paths, shippedConfigs] {
        return planGroup(*document.loaded(), paths, line->text().trimmed().toStdString(), shippedConfigs);
    };
    const auto check = [&document, group, file, planned] {
        const auto plan = planned();
        group->setEnabled(plan.ok());
        file->setText(plan ? trGroup("Saved as %1 with the experiment. It is in the Library from then on.")
                                 .arg(QString::fromStdString(document.shown(plan.value().file)))
                           : QString::fromStdString(plan.error().message));
    };
    QObject::connect(line, &QLineEdit::textChanged, dialog, check);
    QObject::connect(&document, &Document::opened, dialog, &QDialog::reject);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    QObject::connect(buttons, &QDialogButtonBox::accepted, dialog, [&document, dialog, line, planned] {
        const auto plan = planned();
        if (!plan) return Q_EMIT document.refused(QString::fromStdString(plan.error().message));
        (void)applyGroup(document, trGroup("Group into %1").arg(line->text().trimmed()), plan.value()); // which reports a failure
        dialog->accept();
    });
    check();
    dialog->open();
}

} // namespace trundle
