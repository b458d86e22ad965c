#include "editor/shell/dialogs/remote_dialog.h"

#include <QCheckBox>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

#include "editor/running/remote_access.h"
#include "editor/widgets/controls.h"
#include "editor/widgets/theme.h"

namespace trundle {

/// As a string literal of Python, which takes those of JSON.
static QString pythonText(const QString& text) {
    const QByteArray list = QJsonDocument(QJsonArray{text}).toJson(QJsonDocument::Compact);
    return QString::fromUtf8(list.mid(1, list.size() - 2));
}

RemoteDialog::RemoteDialog(RemoteAccess& access, const QString& pythonFolder, QWidget* parent)
    : QDialog(parent), m_access(access), m_pythonFolder(pythonFolder),
      m_on(new QCheckBox(tr("&Let programs on this computer take part in the run"))), m_port(new QSpinBox), m_code(new QLineEdit),
      m_copy(new QToolButton), m_state(new QLabel) {
    setObjectName(QStringLiteral("remoteDialog"));
    setWindowTitle(tr("Remote Control"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_on->setObjectName(QStringLiteral("remoteOn"));
    m_port->setObjectName(QStringLiteral("remotePort"));
    m_port->setRange(0, 65535);
    m_port->setSpecialValueText(tr("any free one"));
    m_code->setObjectName(QStringLiteral("remoteCode"));
    m_code->setReadOnly(true);
    m_code->setFont(figuresFont(12));
    m_code->setMinimumWidth(m_code->fontMetrics().averageCharWidth() * 52);
    m_code->setPlaceholderText(tr("Python code that connects"));
    m_copy->setObjectName(QStringLiteral("remoteCopy"));
    m_copy->setText(tr("&Copy"));
    m_state->setObjectName(QStringLiteral("remoteState"));
    m_state->setWordWrap(true);
    m_state->setTextFormat(Qt::PlainText);
    auto* words = new QLabel(tr("They see signals and images, command robots that are held, step and pause the run. They need "
                                "the token, which is new each time."));
    words->setWordWrap(true);
    auto* code = new QHBoxLayout;
    code->addWidget(m_code, 1);
    code->addWidget(m_copy);
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(12);
    form->addRow(tr("&Port"), m_port);
    form->addRow(tr("In P&ython"), code);
    static_cast<QLabel*>(form->labelForField(code))->setBuddy(m_code);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    auto* column = new QVBoxLayout(this);
    column->setSpacing(12);
    column->addWidget(m_on);
    column->addLayout(form);
    column->addWidget(m_state);
    column->addWidget(words);
    column->addStretch();
    column->addWidget(buttons);
    resizeToFont(*this, {640, 260});
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_on, &QCheckBox::clicked, this, &RemoteDialog::setOn);
    connect(m_copy, &QToolButton::clicked, this, &RemoteDialog::copy);
    connect(&m_access, &RemoteAccess::switched, this, &RemoteDialog::refresh);
    connect(&m_access, &RemoteAccess::clientsChanged, this, &RemoteDialog::refresh);
    if (m_access.isOn()) m_port->setValue(m_access.port());
    refresh();
}

void RemoteDialog::copy() {
    const QString search = QStringLiteral("import sys; sys.path.append(%1)\n").arg(pythonText(m_pythonFolder));
    QGuiApplication::clipboard()->setText(search + m_code->text() + u'\n');
}

void RemoteDialog::setOn(bool on) {
    if (!on) return m_access.stop();
    const QString problem = m_access.start(static_cast<std::uint16_t>(m_port->value()));
    refresh();
    if (!problem.isEmpty()) m_state->setText(problem);
}

void RemoteDialog::refresh() {
    const bool on = m_access.isOn();
    m_on->setChecked(on);
    m_port->setEnabled(!on);
    m_copy->setEnabled(on);
    m_code->setEnabled(on);
    m_code->setText(on ? QStringLiteral("import trundle; run = trundle.connect(%1, \"%2\")")
                             .arg(QString::number(m_access.port()), m_access.token())
                       : QString());
    m_code->setCursorPosition(0);
    const std::size_t clients = m_access.clientCount();
    m_state->setText(!on            ? tr("Off: no program can connect.")
                     : clients == 0 ? tr("Listening at port %1 of this computer; no program is connected.").arg(m_access.port())
                     : clients == 1 ? tr("Listening at port %1 of this computer; one program is connected.").arg(m_access.port())
                                    : tr("Listening at port %1 of this computer; %2 programs are connected.")
                                          .arg(QString::number(m_access.port()), QString::number(clients)));
}

} // namespace trundle
