#include "editor/widgets/save_question.h"

#include <QFileInfo>

#include "editor/widgets/plain_text.h"

namespace trundle {

QString askWhereToSave(QWidget* parent, const QString& title, const QString& start, const QString& filter, const QString& suffix,
                       QFileDialog::Options options) {
    QFileDialog dialog(parent, title, {}, filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setOptions(options);
    dialog.setDefaultSuffix(suffix);
    const QFileInfo proposed(start); // the name may come from an untrusted file or object name
    QString name = shownLine(proposed.fileName().toStdString());
    name.replace(QChar::ReplacementCharacter, QLatin1Char('_'));
    dialog.selectFile(start.contains(QLatin1Char('/')) ? proposed.path() + QLatin1Char('/') + name : name);
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

} // namespace trundle
