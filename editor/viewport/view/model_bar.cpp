#include "editor/viewport/view/model_bar.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "editor/document/document.h"
#include "editor/widgets/actions.h"
#include "editor/widgets/strings.h"
#include "editor/widgets/theme.h"
#include "project/edits/edit_target.h"

namespace trundle {

ModelBar::ModelBar(const Document& document, Actions& actions, QWidget* parent)
    : QFrame(parent), m_document(document), m_actions(actions), m_title(new QLabel), m_detail(new QLabel) {
    setObjectName(QStringLiteral("modelBar"));
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::AlternateBase);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(10, 4, 6, 4);
    addTexts(*row);
    const auto button = [&](const char* name, const char* action) {
        auto* made = new QPushButton;
        made->setObjectName(QLatin1String(name));
        made->setFocusPolicy(Qt::NoFocus); // keys go to the view
        connect(made, &QPushButton::clicked, &m_actions.at(action), &QAction::trigger);
        row->addWidget(made);
        return made;
    };
    QPushButton* joints = button("modelJoints", "model.joints");
    joints->setText(tr("Joints"));
    joints->setToolTip(m_actions.at("model.joints").toolTip());
    joints->setCheckable(true);
    joints->setChecked(m_actions.at("model.joints").isChecked());
    connect(&m_actions.at("model.joints"), &QAction::toggled, joints, &QPushButton::setChecked);
    QPushButton* drive = button("modelDrive", "model.drive");
    QPushButton* done = button("modelDone", "model.edit");
    done->setText(tr("Done"));
    done->setToolTip(tr("Back to the experiment"));
    const QAction& driving = m_actions.at("model.drive");
    const auto showDriving = [this, drive, &driving] {
        drive->setText(driving.isChecked() ? tr("End Test Drive") : tr("Test Drive"));
        show();
    };
    connect(&driving, &QAction::toggled, this, showDriving);
    connect(&m_document.editedModel(), &EditedModel::changed, this, [this, drive, joints] {
        const bool isRobot = m_document.editedModel().path().starts_with("RobotConfig.");
        drive->setVisible(isRobot);
        joints->setVisible(isRobot);
        show();
    });
    connect(&m_document, &Document::changed, this, &ModelBar::show);
    showDriving();
}

/// Below each other, since the buttons leave little room.
void ModelBar::addTexts(QHBoxLayout& row) {
    useFont(*m_title, [] {
        QFont bold = interfaceFont();
        bold.setWeight(QFont::DemiBold);
        return bold;
    });
    m_detail->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_detail->setWordWrap(true);
    m_detail->setForegroundRole(QPalette::PlaceholderText);
    auto* texts = new QVBoxLayout;
    texts->setSpacing(0);
    texts->addWidget(m_title);
    texts->addWidget(m_detail);
    row.addLayout(texts, 1);
}

QString ModelBar::detail() const {
    const Part* config = m_document.editedModel().config();
    if (!config) return {};
    if (m_actions.at("model.drive").isChecked()) return tr("Steer with the arrow keys or W A S D, with Shift twice as fast");
    const LoadedProject& loaded = *m_document.loaded();
    const QString file = toQString(m_document.texts().shown(loaded.paths.at(config->file)));
    if (isShippedFile(loaded, config->file)) return tr("From %1, which is read-only: the first edit makes a copy").arg(file);
    const auto users = static_cast<int>(instancesOf(loaded, *config).size());
    return users > 1 ? tr("Every edit changes all %1 instances").arg(users) : QString();
}

void ModelBar::show() {
    const EditedModel& model = m_document.editedModel();
    const QString name = QString::fromStdString(model.path().substr(model.path().find('.') + 1));
    m_title->setText(m_actions.at("model.drive").isChecked() ? tr("Driving %1").arg(name) : tr("Editing %1").arg(name));
    setVisible(model.isOpen());
    fitDetail();
}

/// What does not fit into two lines beside the buttons ends in an ellipsis; the whole text is its tooltip.
void ModelBar::fitDetail() {
    const QString whole = detail();
    m_detail->setVisible(!whole.isEmpty());
    if (isVisible()) layout()->activate();
    const QFontMetrics metrics = m_detail->fontMetrics();
    const QSize needed = metrics.boundingRect(QRect(0, 0, m_detail->width(), 0), Qt::TextWordWrap, whole).size();
    const bool fits = needed.height() <= 2 * metrics.lineSpacing() && needed.width() <= m_detail->width();
    m_detail->setText(fits ? whole : metrics.elidedText(whole, Qt::ElideRight, m_detail->width()));
    m_detail->setToolTip(whole);
}

void ModelBar::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    fitDetail();
}

} // namespace trundle
