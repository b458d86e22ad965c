#include "editor/cameras/camera_list.h"

#include <algorithm>

#include <QLineEdit>
#include <QListWidget>
#include <QVBoxLayout>

namespace trundle {
namespace {

constexpr std::size_t kFirstShown = 4;

} // namespace

CameraList::CameraList(QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 0, 0, 6);
    column->setSpacing(4);
    m_filter = new QLineEdit;
    m_filter->setObjectName(QStringLiteral("cameraFilter"));
    m_filter->setPlaceholderText(tr("Filter…"));
    m_filter->setAccessibleName(tr("Filter the cameras"));
    m_filter->setClearButtonEnabled(true);
    m_list = new QListWidget;
    m_list->setObjectName(QStringLiteral("cameraList"));
    m_list->setAccessibleName(tr("Cameras"));
    m_list->setUniformItemSizes(true);
    m_list->setTextElideMode(Qt::ElideMiddle);
    setMinimumWidth(120);
    column->addWidget(m_filter);
    column->addWidget(m_list, 1);
    connect(m_filter, &QLineEdit::textChanged, this, &CameraList::filter);
    connect(m_list, &QListWidget::itemChanged, this, [this] {
        m_untouched = false;
        Q_EMIT chosenChanged();
    });
    connect(m_list, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
        if (item) Q_EMIT currentChanged(item->text().toStdString());
    });
}

void CameraList::reset() {
    m_untouched = true;
    m_filter->clear();
}

bool CameraList::lists(const std::vector<std::string>& cameras) const {
    if (m_list->count() != int(cameras.size())) return false;
    for (int i = 0; i < m_list->count(); ++i)
        if (m_list->item(i)->text().toStdString() != cameras[std::size_t(i)]) return false;
    return true;
}

void CameraList::setCameras(const std::vector<std::string>& cameras) {
    const bool untouched = m_untouched;
    std::vector<std::string> wanted = chosen();
    if (untouched) wanted.assign(cameras.begin(), cameras.begin() + std::ptrdiff_t(std::min(kFirstShown, cameras.size())));
    if (!lists(cameras)) {
        const QSignalBlocker quiet(m_list);
        m_list->clear();
        for (const std::string& camera : cameras) {
            auto* item = new QListWidgetItem(QString::fromStdString(camera), m_list);
            item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
            item->setCheckState(Qt::Unchecked);
            item->setToolTip(item->text());
        }
    }
    setChosen(wanted);
    m_untouched = untouched;
    filter();
}

void CameraList::setChosen(const std::vector<std::string>& cameras) {
    {
        const QSignalBlocker quiet(m_list);
        for (int i = 0; i < m_list->count(); ++i) {
            const bool wanted = std::ranges::find(cameras, m_list->item(i)->text().toStdString()) != cameras.end();
            m_list->item(i)->setCheckState(wanted ? Qt::Checked : Qt::Unchecked);
        }
    }
    m_untouched = false;
    Q_EMIT chosenChanged();
}

std::vector<std::string> CameraList::chosen() const {
    std::vector<std::string> cameras;
    for (int i = 0; i < m_list->count(); ++i)
        if (m_list->item(i)->checkState() == Qt::Checked) cameras.push_back(m_list->item(i)->text().toStdString());
    return cameras;
}

void CameraList::filter() {
    const QString text = m_filter->text().trimmed();
    for (int i = 0; i < m_list->count(); ++i)
        m_list->item(i)->setHidden(!m_list->item(i)->text().contains(text, Qt::CaseInsensitive));
}

} // namespace trundle
