#include "editor/properties/section.h"

#include <QToolButton>
#include <QVBoxLayout>

namespace trundle {

Section::Section(const QString& title, bool open, QWidget* parent)
    : QWidget(parent), m_heading(new QToolButton(this)), m_rows(new QWidget(this)), m_layout(new QVBoxLayout(m_rows)) {
    setObjectName(QStringLiteral("section.") + title);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 2);
    layout->setSpacing(1);
    layout->addWidget(m_heading);
    layout->addWidget(m_rows);
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setSpacing(1);
    QFont bold = font();
    bold.setWeight(QFont::DemiBold);
    m_heading->setFont(bold);
    setTitle(title);
    m_heading->setObjectName(QStringLiteral("heading"));
    m_heading->setAutoRaise(true);
    m_heading->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_heading->setFocusPolicy(Qt::NoFocus);
    connect(m_heading, &QToolButton::clicked, this, [this] {
        fold(m_rows->isHidden());
        Q_EMIT folded(!m_rows->isHidden());
    });
    fold(open);
}

void Section::add(QWidget* row) { m_layout->addWidget(row); }

void Section::setTitle(const QString& title) { m_heading->setText(title); }

void Section::fold(bool open) {
    m_rows->setVisible(open);
    m_heading->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    m_heading->setToolTip(open ? tr("Fold") : tr("Unfold"));
}

} // namespace trundle
