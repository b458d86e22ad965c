#pragma once
#include <QTreeWidget>

#include "editor/text/text_fixture.h"

namespace trundle::test {

inline constexpr char kTwoBalls[] = R"(#import parts.sim
Tick = 0.01
Robot one { Config=Ball size=0.2 }
Robot two { Config=Ball body.ball.Mass=2 }
PoseLog log { Robot=one Interval=100 ms }
)";
inline constexpr char kBallConfig[] = R"(Material red { ColorRGB=1,0,0 }
RobotConfig Ball {
  Param size = 0.1
  Body body {
    Sphere ball { Radius=$(size*2) Mass=1 Material=red }
  }
}
)";

/// Two balls whose config is in a second file.
struct TwoBalls : TextFixture {
    std::string parts;
    TwoBalls() {
        parts = write("parts.sim", kBallConfig);
        open(write("drive.sim", kTwoBalls));
    }
    [[nodiscard]] QWidget* child(const char* name) { return panel.window()->findChild<QWidget*>(QLatin1String(name)); }
    template <class T> [[nodiscard]] T* child(const char* name) { return panel.window()->findChild<T*>(QLatin1String(name)); }
    [[nodiscard]] bool listShown() { return child("completionPopup") && child("completionPopup")->isVisible(); }
    [[nodiscard]] QByteArray selected() {
        const TextRange r = edit().selection();
        return shown().mid(r.begin, r.size());
    }
};

} // namespace trundle::test
