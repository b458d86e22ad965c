#include "editor/widgets/save_question.h"

namespace trundle {

QString askWhereToSave(QWidget* parent, const QString& title, const QString& start, const QString& filter, const QString& suffix,
                       QFileDialog::Options options) {
    QFileDialog dialog(parent, title, {}, filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setOptions(options);
    dialog.setDefaultSuffix(suffix);
    dialog.selectFile(start);
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

} // namespace trundle
