#include "editor/viewport/view_settings.h"

#include <cmath>

namespace trundle {

void ViewSettings::setSteps(double moveM, double turnDegrees) {
    if (!(moveM > 0 && turnDegrees > 0 && std::isfinite(moveM) && std::isfinite(turnDegrees))) return;
    if (moveM == m_moveStep && turnDegrees == m_turnStep) return;
    m_moveStep = moveM;
    m_turnStep = turnDegrees;
    Q_EMIT changed();
}

} // namespace trundle
