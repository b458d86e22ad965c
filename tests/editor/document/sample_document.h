#pragma once
// Fixture: a document over a project in a temporary folder, with the real application.

#include <filesystem>
#include <fstream>
#include <sstream>

#include <QSignalSpy>
#include <QTemporaryDir>

#include "editor/document/document.h"
#include "project/loading/search.h"

namespace sample {

using namespace trundle;

inline std::string bytesOf(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream bytes;
    bytes << file.rdbuf();
    return bytes.str();
}

inline const char* kRover = R"(// A rover.
RobotConfig Rover {
  Body chassis { Box hull { Size=0.3,0.2,0.1 Pos=0,0,0.09 Mass=2 } } // two kilograms
  Body leftWheel { Pos=0,0.1,0.05 Cylinder tyre { Radius=0.05 Length=0.03 HPR=0,0,90 Mass=0.15 } }
  Body rightWheel { Pos=0,-0.1,0.05 Cylinder tyre { Radius=0.05 Length=0.03 HPR=0,0,90 Mass=0.15 } }
  Hinge leftAxle { Parent=chassis Child=leftWheel Axis=0,1,0 }
  Hinge rightAxle { Parent=chassis Child=rightWheel Axis=0,1,0 }
}
)";
inline const char* kMain = R"(Tick = 0.01
Duration = 10
#import robots/rover.sim

Robot robot0 {
  Config=Rover   Pos=0,0,0  // start
}

Robot robot1 { Config=Rover Pos=1,0,0 }
)";

/// The folder `configs/` makes it a project.
class DocumentFixture {
public:
    DocumentFixture() {
        m_root = std::filesystem::canonical(m_dir.path().toStdString()).string();
        qputenv("XDG_STATE_HOME", QByteArray::fromStdString(m_root + "/state"));
        robot = write("configs/robots/rover.sim", kRover);
        main = write("configs/main.sim", kMain);
    }
    std::string path(const std::string& name) const { return m_root + "/" + name; }
    std::string write(const std::string& name, const std::string& bytes) const {
        const std::string file = path(name);
        std::filesystem::create_directories(std::filesystem::path(file).parent_path());
        std::ofstream(file, std::ios::binary) << bytes;
        return file;
    }

    std::string main, robot;

private:
    QTemporaryDir m_dir;
    std::string m_root;
};

/// The message of a failed status, "" on success.
inline std::string why(const Status& status) { return status.ok() ? std::string() : status.error().message; }

/// The messages of all errors found while loading, one per line.
inline std::string messages(const LoadedProject& loaded) {
    std::string all;
    for (const Diagnostic& d : loaded.diagnostics.all())
        if (d.severity == Severity::Error) all += d.message + "\n";
    return all;
}

/// The text argument of a recorded signal.
inline std::string reportOf(const QSignalSpy& spy, int which = 0) { return spy.at(which).at(0).toString().toStdString(); }
inline bool holds(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

} // namespace sample
