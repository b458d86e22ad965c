#include "editor/running/panels/speeds.h"

#include <cmath>

namespace trundle {

int speedIndex(double factor) {
    if (factor <= 0) return static_cast<int>(kSpeeds.size()) - 1;
    int best = 0;
    for (int i = 1; i + 1 < static_cast<int>(kSpeeds.size()); ++i) {
        const auto distance = [&](int at) { return std::abs(std::log(kSpeeds[static_cast<std::size_t>(at)] / factor)); };
        if (distance(i) < distance(best)) best = i;
    }
    return best;
}

QString speedText(double factor) { return factor > 0 ? QString::number(factor) + QStringLiteral("×") : QStringLiteral("max"); }

QString timeText(double seconds) {
    if (seconds < 3600) return QStringLiteral("t = %1 s").arg(seconds, 0, 'f', 2);
    const double whole = std::floor(seconds / 60);
    return QStringLiteral("t = %1:%2:%3")
        .arg(std::floor(whole / 60), 0, 'f', 0)
        .arg(static_cast<int>(std::fmod(whole, 60)), 2, 10, QLatin1Char('0'))
        .arg(seconds - 60 * whole, 4, 'f', 1, QLatin1Char('0'));
}

QString factorText(double factor) {
    const int decimals = factor < 9.95 ? (factor < 0.995 ? 2 : 1) : 0;
    return QString::number(factor, 'f', decimals) + QStringLiteral("×");
}

} // namespace trundle
