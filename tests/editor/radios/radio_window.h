#pragma once
// Fixture: the Radio dock over one document and its run, connected as in the main window.

#include <QtTest>

#include "editor/document/selection.h"
#include "editor/radios/budget_page.h"
#include "editor/radios/packets_page.h"
#include "editor/radios/radios_panel.h"
#include "editor/running/session_fixture.h"
#include "eventually.h"
#include "radio/medium.h"

namespace trundle {

struct RadioWindow : SessionFixture {
    RadioWindow() {
        panel.resize(1000, 320);
        panel.show();
        (void)QTest::qWaitForWindowExposed(&panel, kTimeoutMs);
        QObject::connect(&panel, &RadiosPanel::messageRequested, [this](const QString& words) { reportOf.push_back(words); });
    }
    /// Runs until the given tick, pauses and waits until everything is shown.
    [[nodiscard]] bool runTo(std::uint64_t ticks) {
        session.setSpeed(0);
        const std::uint64_t before = tick();
        session.runFor(double(ticks - before) * document.loaded()->experiment->settings.tick);
        return QTest::qWaitFor([&] { return session.state() == RunState::Paused && tick() == ticks; }, 60000) && settled();
    }
    [[nodiscard]] bool settled() {
        return QTest::qWaitFor([&] { return panel.isSettled(); }, 10000);
    }
    [[nodiscard]] PacketModel& model() { return panel.packets().model(); }
    template <class T> [[nodiscard]] T* find(const char* name) { return panel.findChild<T*>(QLatin1String(name)); }
    /// The same run without a window, with all its packets.
    struct Headless {
        std::unique_ptr<Runner> runner;
        std::shared_ptr<RadioTrace> trace;
    };
    [[nodiscard]] Headless headless(std::uint64_t ticks, const std::string& logs = {}) {
        Diagnostics problems;
        RunOptions options;
        options.logFolder = logs;
        Headless run;
        run.runner = application->makeRunner(*document.loaded(), std::move(options), problems);
        if (run.runner) run.trace = run.runner->world().medium()->trace();
        for (std::uint64_t i = 0; run.runner && i < ticks; ++i)
            if (!run.runner->tick().ok()) run.runner.reset();
        return run;
    }
    [[nodiscard]] QByteArray content(const QString& name) const {
        QFile file(folder.filePath(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }

    Selection selection;
    RadiosPanel panel{document, selection, session};
    std::vector<QString> reportOf;
};

/// Six motes in two rows, a target that they report, one mote that never sends and one out of range.
inline const QByteArray kMotes = R"(Tick = 0.01  Duration = 2
#import robots/tmote_sky.sim
#import arenas/open_floor.sim
#loadModule controllers/mote
Static floor { Config=OpenFloor }
RadioMedium air { Collisions=true }
Robot target { Config=TmoteSky  Mote brain { Target=true Period=0.05 Power=-3 } }
Grid motes { Config=TmoteSky Pos=4,0,0 Count=3,2 Spacing=2,1.5  Mote brain { Period=0.05 } }
Robot deaf { Config=TmoteSky Pos=0,3,0 radio.BufferLimit=2 }
Robot far { Config=TmoteSky Pos=720,0,0 HPR=90,0,0  Mote brain { Power=-25 } }
RadioLog frames { }
RadioLog sniffer { Format=pcap File=frames.pcap }
)";

} // namespace trundle
