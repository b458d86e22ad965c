#include "editor/viewport/context/view_settings.h"

#include <cmath>

#include <QSettings>

namespace trundle {

void ViewSettings::keepBetweenStarts() {
    const QSettings kept;
    const auto number = [&](const char* name, double other) {
        return kept.value(QStringLiteral("views/") + QLatin1String(name), other).toDouble();
    };
    m_snaps = kept.value(QStringLiteral("views/snaps"), m_snaps).toBool();
    m_axes = AxesOf(std::clamp(kept.value(QStringLiteral("views/axes"), int(m_axes)).toInt(), 0, int(AxesOf::Local)));
    m_look = LookChoice(std::clamp(kept.value(QStringLiteral("views/look"), int(m_look)).toInt(), 0, int(LookChoice::Rich)));
    m_overlays = kept.value(QStringLiteral("views/overlays"), m_overlays).toUInt();
    setSteps(number("moveStep", m_moveStep), number("turnStep", m_rotationStep));
    Q_EMIT changed();
    connect(this, &ViewSettings::changed, this, [this] {
        QSettings settings;
        settings.setValue(QStringLiteral("views/snaps"), m_snaps);
        settings.setValue(QStringLiteral("views/axes"), int(m_axes));
        settings.setValue(QStringLiteral("views/look"), int(m_look));
        settings.setValue(QStringLiteral("views/overlays"), m_overlays);
        settings.setValue(QStringLiteral("views/moveStep"), m_moveStep);
        settings.setValue(QStringLiteral("views/turnStep"), m_rotationStep);
    });
}

void ViewSettings::setSteps(double moveM, double turnDegrees) {
    if (!(moveM > 0 && turnDegrees > 0 && std::isfinite(moveM) && std::isfinite(turnDegrees))) return;
    if (moveM == m_moveStep && turnDegrees == m_rotationStep) return;
    m_moveStep = moveM;
    m_rotationStep = turnDegrees;
    Q_EMIT changed();
}

} // namespace trundle
