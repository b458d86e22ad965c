#pragma once
// Opens experiments given as text, as the programs do, and returns the diagnostics of the model check.

#include <filesystem>
#include <fstream>

#include <QTemporaryDir>
#include <QTest>

#include "app/application.h"
#include "check/model_check.h"
#include "lang/diagnostic_text.h"
#include "lang/tree_edit.h"

namespace fixture {

using namespace trundle;

struct CheckFixture {
    QTemporaryDir folder;
    std::unique_ptr<Application> application = makeApplication();

    [[nodiscard]] std::shared_ptr<const LoadedProject> open(const std::string& text) const {
        const std::filesystem::path path = std::filesystem::path(folder.path().toStdString()) / "configs" / "main.sim";
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << text;
        return openFile(path.string());
    }
    [[nodiscard]] std::shared_ptr<const LoadedProject> openFile(const std::string& path) const {
        auto loaded = application->open(path, {});
        return loaded ? loaded.value() : nullptr;
    }
    [[nodiscard]] static Diagnostics check(const LoadedProject& loaded) {
        Diagnostics found;
        checkModel(loaded, found);
        return found;
    }
    [[nodiscard]] static std::string shown(const LoadedProject& loaded, const Diagnostics& found) {
        std::string text;
        for (const Diagnostic& d : loaded.diagnostics.all())
            if (d.severity == Severity::Error) text += render(d, loaded.sources);
        for (const Diagnostic& d : found.all()) text += render(d, loaded.sources);
        return text;
    }
    /// The text of the first file with a fix applied.
    [[nodiscard]] static std::string applied(const LoadedProject& loaded, const Fix& fix) {
        const auto bytes = applyEdits(loaded.trees[0]->source().bytes(), fix.edits);
        return bytes.ok() ? bytes.value() : std::string();
    }
};

/// A floor, and configs of objects to put on it.
inline const std::string kThings = R"(
Tick = 0.01 Duration = 1
StaticConfig Floor { Plane ground { } }
Static floor { Config=Floor }
RobotConfig Crate { Body b { Box hull { Size=0.2,0.2,0.2 Mass=1 } } }
RobotConfig Ball { Body b { Sphere s { Radius=0.1 Mass=1 } } }
RobotConfig Post { Body b { Cylinder c { Radius=0.05 Length=0.4 Mass=1 } } }
RobotConfig Pill { Body b { Pos=0,0,0.1 Capsule c { Pos=0.1,0,0 HPR=0,90,0 Radius=0.05 Length=0.4 Mass=1 } } }
)";

} // namespace fixture
