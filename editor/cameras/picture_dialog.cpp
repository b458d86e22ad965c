#include "editor/cameras/picture_dialog.h"

#include <mutex>

#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "editor/cameras/size_choice.h"
#include "editor/widgets/save_question.h"
#include "render/image.h"

namespace trundle {

/// Lets the render thread reach the dialog if it still exists. Outlives the dialog.
struct PictureDialog::Inbox {
    std::mutex lock;
    PictureDialog* dialog = nullptr;
};

PictureDialog::PictureDialog(RenderService& render, PictureSource still, QSize shown, const QString& file, QWidget* parent)
    : QDialog(parent), m_render(render), m_still(std::move(still)), m_inbox(std::make_shared<Inbox>()),
      m_size(new SizeChoice(shown)), m_file(new QLineEdit(QDir::toNativeSeparators(file))), m_words(new QLabel) {
    m_inbox->dialog = this;
    setObjectName(QStringLiteral("pictureDialog"));
    setWindowTitle(tr("Save Picture"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* column = new QVBoxLayout(this);
    column->setSpacing(12);
    auto* form = new QFormLayout;
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_file->setObjectName(QStringLiteral("pictureFile"));
    auto* choose = new QPushButton(tr("&Browse…"));
    auto* path = new QHBoxLayout;
    path->addWidget(m_file, 1);
    path->addWidget(choose);
    form->addRow(tr("Si&ze"), m_size);
    form->addRow(tr("File"), path);
    column->addLayout(form);
    m_words->setObjectName(QStringLiteral("pictureWords"));
    m_words->setWordWrap(true);
    m_words->setMinimumWidth(440);
    m_words->setMinimumHeight(2 * fontMetrics().lineSpacing());
    m_words->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    column->addWidget(m_words);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    m_save = buttons->addButton(tr("&Save"), QDialogButtonBox::ActionRole);
    m_save->setObjectName(QStringLiteral("pictureSave"));
    column->addWidget(buttons);
    for (QPushButton* button : findChildren<QPushButton*>())
        button->setAutoDefault(false); // else Enter would press the focused button
    m_save->setDefault(true);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_save, &QPushButton::clicked, this, &PictureDialog::save);
    connect(choose, &QPushButton::clicked, this, &PictureDialog::browse);
    connect(m_file, &QLineEdit::textChanged, this, &PictureDialog::showReady);
    showReady();
}

PictureDialog::~PictureDialog() {
    const std::scoped_lock guard(m_inbox->lock);
    m_inbox->dialog = nullptr;
}

void PictureDialog::showReady() {
    const QFileInfo file(m_file->text().trimmed());
    const QString ending = file.suffix().toLower();
    QString why;
    if (ending != QStringLiteral("png") && ending != QStringLiteral("jpg") && ending != QStringLiteral("jpeg"))
        why = tr("The file name must end in .png or .jpg.");
    else if (!file.absoluteDir().exists()) why = tr("The folder does not exist.");
    m_save->setEnabled(why.isEmpty());
    m_words->setText(!why.isEmpty()  ? why
                     : file.exists() ? tr("The file exists and will be replaced.")
                                     : tr("The view without selection marks and handles."));
}

void PictureDialog::browse() {
    const QString path = askWhereToSave(this, tr("Save Picture"), m_file->text(), tr("Pictures (*.png *.jpg *.jpeg)"),
                                        QStringLiteral("png"), QFileDialog::DontConfirmOverwrite);
    if (!path.isEmpty()) m_file->setText(QDir::toNativeSeparators(path));
}

void PictureDialog::save() {
    const QString path = QDir::fromNativeSeparators(m_file->text().trimmed());
    m_save->setEnabled(false);
    m_words->setText(tr("Drawing…"));
    const QSize size = m_size->size();
    m_render.draw(
        m_still(std::uint32_t(size.width()), std::uint32_t(size.height())), [inbox = m_inbox, path](Result<Image> image) {
            const Status saved = image ? saveImage(image.value(), path.toStdString()) : Status(image.error());
            const QString failure = saved ? QString() : QString::fromStdString(saved.error().message);
            const std::scoped_lock guard(inbox->lock);
            if (!inbox->dialog) return;
            QMetaObject::invokeMethod(
                inbox->dialog, [dialog = inbox->dialog, path, failure] { dialog->take(path, failure); }, Qt::QueuedConnection);
        });
}

void PictureDialog::take(const QString& path, const QString& failure) {
    m_save->setEnabled(true);
    if (!failure.isEmpty()) return m_words->setText(failure);
    Q_EMIT written(QDir::toNativeSeparators(path));
    accept();
}

} // namespace trundle
