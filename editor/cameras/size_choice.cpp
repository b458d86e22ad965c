#include "editor/cameras/size_choice.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>

#include "render/service.h"

namespace trundle {
namespace {

QSpinBox* side(const char* name, const QString& words) {
    auto* box = new QSpinBox;
    box->setObjectName(QLatin1String(name));
    box->setAccessibleName(words);
    box->setRange(16, int(kMaxPixels));
    box->setGroupSeparatorShown(false);
    return box;
}

} // namespace

SizeChoice::SizeChoice(QSize shown, QWidget* parent)
    : QWidget(parent), m_named(new QComboBox), m_width(side("pictureWidth", tr("Width"))),
      m_height(side("pictureHeight", tr("Height"))) {
    setObjectName(QStringLiteral("sizeChoice"));
    m_named->setObjectName(QStringLiteral("pictureSize"));
    m_named->setAccessibleName(tr("Size"));
    if (!shown.isEmpty()) m_named->addItem(tr("Screen size"), shown);
    m_named->addItem(tr("HD"), QSize(1280, 720));
    m_named->addItem(tr("Full HD"), QSize(1920, 1080));
    m_named->addItem(tr("4K"), QSize(3840, 2160));
    m_named->addItem(tr("Other"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_named, 1);
    row->addWidget(m_width);
    row->addWidget(new QLabel(QStringLiteral("×")));
    row->addWidget(m_height);
    setSize(shown.isEmpty() ? QSize(1280, 720) : shown);
    connect(m_named, &QComboBox::activated, this, &SizeChoice::takeNamed);
    for (QSpinBox* box : {m_width, m_height})
        connect(box, &QSpinBox::valueChanged, this, [this] {
            showName();
            Q_EMIT changed();
        });
}

QSize SizeChoice::size() const { return {m_width->value(), m_height->value()}; }

void SizeChoice::setSize(QSize size) {
    {
        const QSignalBlocker quietWidth(m_width), quietHeight(m_height);
        m_width->setValue(size.width());
        m_height->setValue(size.height());
    }
    showName();
    Q_EMIT changed();
}

void SizeChoice::takeNamed() {
    if (m_named->currentData().isValid()) setSize(m_named->currentData().toSize());
    else m_width->setFocus();
}

void SizeChoice::showName() {
    const int known = m_named->findData(size());
    m_named->setCurrentIndex(known >= 0 ? known : m_named->count() - 1);
}

} // namespace trundle
