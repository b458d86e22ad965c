#include "editor/shell/dialogs/share_dialog.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QMessageBox>
#include <QPushButton>

#include "editor/widgets/name_list.h"

namespace trundle {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("ShareDialog", text); }

constexpr qsizetype kMaxUsersNamed = 8;

QString dependentsOf(const ShareQuestion& question) {
    const auto files = question.users.size();
    if (files > 1) return tr("%1 files use it").arg(files);
    if (question.instances > 1) return tr("%1 instances use it").arg(question.instances);
    return files == 1 ? tr("1 file uses it") : tr("no file uses it yet");
}

/// Long names are shortened in the middle, since neither a button nor a label can wrap them.
QString shortName(const QString& name) {
    constexpr qsizetype kMost = 28;
    return name.size() <= kMost ? name : name.left(kMost / 2) + QChar(0x2026) + name.right(kMost / 2 - 1);
}

/// Text of the copy button: which instances will use the copy.
QString copyButtonText(const ShareQuestion& question) {
    const auto some = question.copyFor.size();
    if (some == 1 && question.instances > 1) return tr("Make a copy for %1").arg(shortName(question.copyFor.front()));
    if (some > 0 && std::size_t(some) < question.instances) return tr("Make a copy for these %1").arg(some);
    return question.copyIsForOpened ? tr("Make a copy for this experiment")
                                    : tr("Make a copy for %1").arg(shortName(question.copyFile));
}

QString changeOf(const ShareQuestion& question) {
    const QString config = shortName(question.config);
    if (question.isShipped)
        return tr("This changes the value of %1 in %2, which came with Trundle and is read-only.")
            .arg(shortName(question.value), config);
    if (question.value.isEmpty())
        return tr("This changes the structure of %1, which is defined in %2.").arg(config, question.file);
    return tr("This changes the value of %1 in %2, which is defined in %3.")
        .arg(shortName(question.value), config, question.file);
}

} // namespace

void askAboutSharedConfig(QWidget* parent, const ShareQuestion& question, const StructureEdits::ShareAnswer& answer) {
    auto* box = new QMessageBox(QMessageBox::Question, tr("Shared config"), changeOf(question), QMessageBox::Cancel, parent);
    box->setObjectName(QStringLiteral("shareQuestion"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    const bool one = question.copyFor.size() == 1;
    QStringList names;
    for (const QString& name : question.copyFor) names << shortName(name);
    QString more = question.users.isEmpty()
                       ? QString()
                       : tr("Used by %1.").arg(listed(question.users, kMaxUsersNamed)) + QStringLiteral("\n\n");
    more +=
        question.copyFor.isEmpty() ? tr("A copy goes into %1.").arg(question.copyFile)
        : one
            ? tr("A copy goes into %1, and %2 uses it from then on.").arg(question.copyFile, shortName(question.copyFor.front()))
            : tr("A copy goes into %1, and %2 use it from then on.").arg(question.copyFile, listed(names, kMaxUsersNamed));
    box->setInformativeText(more + QLatin1Char(' ') +
                            tr("The choice applies to %1 until this window closes.").arg(shortName(question.config)));
    const QString forAll = question.isShipped
                               ? tr("Make a copy for all (%1)").arg(dependentsOf(question))
                               : tr("Change %1 for all (%2)").arg(shortName(question.config), dependentsOf(question));
    QPushButton* all = box->addButton(forAll, QMessageBox::AcceptRole);
    all->setObjectName(QStringLiteral("changeForAll"));
    QPushButton* copy = box->addButton(copyButtonText(question), QMessageBox::AcceptRole);
    copy->setObjectName(QStringLiteral("makeCopy"));
    box->setDefaultButton(copy); // what else uses the config stays as it is
    auto* buttons = box->findChild<QDialogButtonBox*>();
    buttons->setOrientation(Qt::Vertical); // the texts are too long for one row
    buttons->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    QObject::connect(box, &QMessageBox::finished, box, [box, all, copy, answer] {
        const QAbstractButton* clicked = box->clickedButton();
        answer(clicked == all ? ShareChoice::ChangeForAll : clicked == copy ? ShareChoice::MakeCopy : ShareChoice::Cancel);
    });
    box->open();
}

} // namespace trundle
