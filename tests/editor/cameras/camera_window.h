#pragma once
// Fixture: the 3D views and the Cameras dock over one document and its run, connected as in the main window.

#include "editor/cameras/cameras_panel.h"
#include "editor/viewport/view_window.h"
#include "eventually.h"

namespace trundle {

struct CameraWindow : ViewWindow {
    explicit CameraWindow(RenderService* render) : ViewWindow(render), cameras(document, session, render) {
        cameras.resize(700, 300);
        cameras.show();
        (void)QTest::qWaitForWindowExposed(&cameras, kTimeoutMs);
        QObject::connect(&cameras, &CamerasPanel::messageRequested, [this](const QString& words) { reportOf.push_back(words); });
    }
    [[nodiscard]] const CameraTiles::Tile* tile(const std::string& camera) {
        for (const CameraTiles::Tile& tile : cameras.wall().tiles())
            if (tile.camera == camera) return &tile;
        return nullptr;
    }
    /// Runs for the given number of ticks, pauses and waits until everything is drawn.
    [[nodiscard]] bool runTicks(std::uint64_t ticks) {
        session.setSpeed(0);
        session.runFor(double(ticks) * document.loaded()->experiment->settings.tick);
        return QTest::qWaitFor([&] { return session.state() == RunState::Paused && session.results().snapshot->tick == ticks; },
                               60000) &&
               QTest::qWaitFor([&] { return cameras.isSettled(); }, 20000);
    }
    /// The same run without a window.
    [[nodiscard]] std::unique_ptr<Runner> headless(std::uint64_t ticks, const std::string& logs = {}) {
        Diagnostics problems;
        RunOptions options;
        options.logFolder = logs;
        std::unique_ptr<Runner> runner = application->makeRunner(*document.loaded(), std::move(options), problems);
        for (std::uint64_t i = 0; runner && i < ticks; ++i)
            if (!runner->tick().ok()) return nullptr;
        return runner;
    }

    CamerasPanel cameras;
    std::vector<QString> reportOf;
};

/// Two robots that see each other; one has a logging camera with noise and lens distortion.
inline const QByteArray kTwoEyes = R"(Tick = 0.01   Seed = 5
#import robots/camera_robot.sim
#import arenas/colour_yard.sim
#loadModule controllers/blob_follow
Static yard { Config=ColourYard }
Robot robot0 { Config=CameraRobot Pos=-1,0,0 BlobFollow brain { Speed=0.3 KeepEvery=0 } }
Robot robot1 { Config=CameraRobot Pos=0.6,0.5,0 HPR=150,0,0
  eye.Mode=depth eye.Noise=0.05 eye.Distortion=-0.2,0.02 eye.SeesSelf=false }
)";

} // namespace trundle
