#pragma once
// Fixture: a document with a text in a temporary folder, and its run.

#include <QFile>
#include <QTemporaryDir>

#include "editor/document/document.h"
#include "editor/document/structure_edits.h"
#include "editor/running/session.h"

namespace trundle {

struct SessionFixture {
    QTemporaryDir folder;
    std::unique_ptr<Application> application = makeApplication();
    Document document{*application};
    RunSession session{document, *application};

    [[nodiscard]] QString path(const char* name = "trial.sim") const { return folder.filePath(QLatin1String(name)); }
    bool open(const QByteArray& text, const char* name = "trial.sim") {
        QFile file(path(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) return false;
        file.close();
        return document.opening().open(path(name).toStdString()).ok();
    }
    /// Opens a copy of the experiment of configs/, so that logs go to the temporary folder.
    bool openSample(const char* name) {
        QFile sample(QStringLiteral(TRUNDLE_SOURCE_DIR "/configs/experiments/") + QLatin1String(name));
        return sample.open(QIODevice::ReadOnly) && open(sample.readAll(), name);
    }
    [[nodiscard]] std::uint64_t tick() const { return session.results().snapshot ? session.results().snapshot->tick : 0; }
};

/// One robot on a floor, with a controller that does not move it.
inline const QByteArray kStandingRobot = R"(Tick = 0.01
#import robots/simple_robot.sim
#import arenas/medium_arena.sim
Static arena { Config=MediumArena Pos=0,0,0 }
Robot robot0 { Config=SimpleRobot Pos=0,0,0 HPR=0,0,0 }
)";

} // namespace trundle
