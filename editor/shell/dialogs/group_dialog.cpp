#include "editor/shell/dialogs/group_dialog.h"

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

/// Asks for the name of the piece and shows the file that it will be saved in.
class GroupDialog final : public QDialog {
public:
    GroupDialog(QWidget* parent, Document& document, std::vector<std::string> paths, std::string shippedConfigs,
                const QString& name)
        : QDialog(parent), m_document(document), m_paths(std::move(paths)), m_shippedConfigs(std::move(shippedConfigs)),
          m_name(new QLineEdit(name)), m_file(new QLabel) {
        setObjectName(QStringLiteral("groupDialog"));
        setWindowTitle(trGroup("Group into Piece"));
        setAttribute(Qt::WA_DeleteOnClose);
        auto* words =
            new QLabel(m_paths.size() == 1
                           ? trGroup("The selected object becomes a piece that can be placed again.")
                           : trGroup("The %1 selected objects become one piece that can be placed again.").arg(m_paths.size()));
        m_name->setObjectName(QStringLiteral("groupName"));
        m_name->setAccessibleName(trGroup("Name of the piece"));
        m_name->selectAll();
        m_file->setObjectName(QStringLiteral("groupFile"));
        m_file->setTextFormat(Qt::PlainText);
        m_file->setWordWrap(true);
        m_file->setMinimumWidth(360);
        auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
        m_group = buttons->addButton(trGroup("Group"), QDialogButtonBox::AcceptRole);
        m_group->setDefault(true);
        auto* layout = new QVBoxLayout(this);
        for (QWidget* widget : std::initializer_list<QWidget*>{words, m_name, m_file, buttons}) layout->addWidget(widget);
        connect(m_name, &QLineEdit::textChanged, this, [this] { check(); });
        connect(&document, &Document::opened, this, &QDialog::reject);
        connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
        connect(buttons, &QDialogButtonBox::accepted, this, [this] { group(); });
        check();
    }

private:
    [[nodiscard]] Result<GroupPlan> planned() const {
        return planGroup(*m_document.loaded(), m_paths, m_name->text().trimmed().toStdString(), m_shippedConfigs);
    }
    void check() {
        const auto plan = planned();
        m_group->setEnabled(plan.ok());
        m_file->setText(plan ? trGroup("Saved as %1 with the experiment. It is in the Library from then on.")
                                   .arg(QString::fromStdString(m_document.texts().shown(plan.value().file)))
                             : QString::fromStdString(plan.error().message));
    }
    void group() {
        const auto plan = planned();
        if (!plan) return Q_EMIT m_document.refused(QString::fromStdString(plan.error().message));
        (void)applyGroup(m_document, trGroup("Group into %1").arg(m_name->text().trimmed()), plan.value()); // reports a failure
        accept();
    }

    Document& m_document;
    const std::vector<std::string> m_paths;
    const std::string m_shippedConfigs;
    QLineEdit* m_name;
    QLabel* m_file;
    QPushButton* m_group = nullptr;
};

} // namespace

void askForGroup(QWidget* parent, Document& document, const std::vector<std::string>& paths, const std::string& shippedConfigs) {
    if (!document.isOpen()) return;
    if (document.isNew() || document.texts().isSample(document.path()))
        return Q_EMIT document.refused(trGroup("A piece is a file beside the experiment: save the experiment first."));
    const std::string name = freeGroupName(*document.loaded(), shippedConfigs);
    if (const auto plan = planGroup(*document.loaded(), paths, name, shippedConfigs); !plan)
        return Q_EMIT document.refused(QString::fromStdString(plan.error().message));
    (new GroupDialog(parent, document, paths, shippedConfigs, QString::fromStdString(name)))->open();
}

} // namespace trundle
