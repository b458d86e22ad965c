#pragma once
// Fixture: a visible property panel over a document in a temporary folder, with the program's real kinds and optional test kinds.

#include <filesystem>
#include <fstream>

#include <QApplication>
#include <QLabel>
#include <QMenu>
#include <QTemporaryDir>
#include <QTest>

#include "control/directory_catalog.h"
#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/document/structure_edits.h"
#include "editor/properties/editors/value_field.h"
#include "editor/properties/properties_panel.h"
#include "editor/widgets/apply_theme.h"
#include "eventually.h"
#include "model/kinds/model_kinds.h"

namespace trundle {

/// Returns a cube for every mesh: the shape does not matter here.
class CubeMeshes final : public MeshSource {
public:
    Result<std::shared_ptr<const TriangleMesh>> mesh(const std::string&) override {
        auto cube = std::make_shared<TriangleMesh>();
        for (int i = 0; i < 8; ++i) cube->points.push_back({i & 1 ? 0.1 : 0.0, i & 2 ? 0.1 : 0.0, i & 4 ? 0.1 : 0.0});
        cube->triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                           {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
        return std::shared_ptr<const TriangleMesh>(cube);
    }
    Result<std::shared_ptr<const HeightMap>> heightMap(const std::string&) override {
        return std::make_shared<const HeightMap>(HeightMap{2, 2, {0, 1, 0, 1}});
    }
};

/// The application with the kinds of all modules, without #loadModule, and those of `extra`.
class FixtureApplication final : public Application {
public:
    FixtureApplication() : m_application(makeApplication()), m_registry(std::make_shared<Registry>(*m_application->builtIn())) {
        for (Kind& kind : m_application->moduleKinds({})) add(std::move(kind));
    }
    void add(Kind kind) {
        const Status added = m_registry->add(withControllerProperties(std::move(kind)));
        if (!added) qFatal("%s", added.error().message.c_str());
    }

    std::shared_ptr<const Registry> builtIn() const override { return m_registry; }
    std::vector<Kind> moduleKinds(const OpenOptions& options) const override { return m_application->moduleKinds(options); }
    const Locations& locations() const override { return m_application->locations(); }
    Result<std::shared_ptr<const LoadedProject>> open(const std::string& path, const OpenOptions& o) override {
        DirectoryCatalog catalog({o.modules, {}, {}, false});
        Project project(
            std::make_shared<const Registry>(*m_registry), catalog, m_meshes,
            {o.includes, locations().configs, locations().resources, o.sets, o.texts, o.previous, o.shownFromProject});
        return project.open(path);
    }
    std::unique_ptr<Runner> makeRunner(const LoadedProject&, RunOptions, Diagnostics&) override { return nullptr; }

private:
    std::unique_ptr<Application> m_application;
    std::shared_ptr<Registry> m_registry;
    CubeMeshes m_meshes;
};

inline const char* kRoverFile = R"(Material grey { ColorRGB=0.5,0.5,0.5 }
Material red { ColorRGB = 0.9, 0.1, 0.1 }
Surface rubber { Friction=1 }
RobotConfig Rover {
  Param wheelRadius = 5 cm   // of both
  Param track = 0.25
  Body chassis { Box hull { Size=0.3,0.2,0.1 Pos=0,0,0.09 Mass=2 Material=grey Surface=rubber } }
  Body leftWheel { Pos=0, $(track/2), $wheelRadius
    Cylinder tyre { Radius=$wheelRadius Length=0.03 HPR=0,0,90 Mass=0.15 Material=grey Surface=rubber } }
  Body rightWheel { Pos=0, $(-track/2), $wheelRadius
    Cylinder tyre { Radius=$wheelRadius Length=0.03 HPR=0,0,90 Mass=0.15 Material=grey Surface=rubber } }
  Hinge leftAxle { Parent=chassis Child=leftWheel Axis=0,1,0 }
  Hinge rightAxle { Parent=chassis Child=rightWheel Axis=0,1,0 }
  RotaryMotor leftMotor { Joint=leftAxle TorqueConstant=0.02 SpeedConstant=50 Resistance=2 MaxVoltage=12 }
  RotaryMotor rightMotor { Joint=rightAxle TorqueConstant=0.02 SpeedConstant=50 Resistance=2 MaxVoltage=12 }
  Encoder leftEncoder { Joint=leftAxle }
  TouchSensor touch { Geom=chassis.hull }
}
)";

struct PropertiesFixture {
    QTemporaryDir folder;
    FixtureApplication application;
    Document document{application};
    Selection selection;
    PropertiesPanel panel{document, selection, nullptr};

    PropertiesFixture() {
        panel.resize(340, 900);
        panel.show();
        if (!QTest::qWaitForWindowActive(&panel, kTimeoutMs)) qFatal("the panel has no focus");
        // As the window does.
        QObject::connect(&document, &Document::selectionRequested, &selection, [this](const std::vector<std::string>& paths) {
            if (!paths.empty()) selection.set(paths);
        });
    }

    std::string write(const char* name, const std::string& text) const {
        const std::filesystem::path path = std::filesystem::path(folder.path().toStdString()) / "configs" / name;
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << text;
        return path.string();
    }
    /// Writes the rover to a file of its own and opens this text as the experiment.
    bool open(const std::string& text) {
        write("rover.sim", kRoverFile);
        return document.opening().open(write("main.sim", "#import rover.sim\n" + text)).ok() &&
               QTest::qWaitFor([this] { return !panel.isVisible() || panel.findChild<QWidget*>(QStringLiteral("rows")); });
    }
    std::string text(std::size_t file = 0) const { return *document.texts().text(document.texts().files().at(file)); }
    std::string rover() const { return text(1); }

    QWidget* row(const char* id) const { return panel.findChild<QWidget*>(QStringLiteral("row.") + QLatin1String(id)); }
    template <class W = ValueField> W* field(const char* id, const char* name = "field") const {
        QWidget* found = row(id);
        return found ? found->findChild<W*>(QLatin1String(name)) : nullptr;
    }
    QString shown(const char* id, const char* name = "field") const {
        const auto* f = field<QLineEdit>(id, name);
        return f ? f->text() : QStringLiteral("(no field)");
    }
    /// Types into a row and commits.
    void type(const char* id, const QString& text, const char* name = "field") const {
        auto* f = field<QLineEdit>(id, name);
        QVERIFY2(f, id);
        f->setFocus();
        f->selectAll();
        QTest::keyClick(f, Qt::Key_Delete);
        const bool keys = std::all_of(text.begin(), text.end(), [](QChar c) { return c.unicode() < 128; });
        if (keys) QTest::keyClicks(f, text);
        else f->insert(text); // as by pasting
        QTest::keyClick(f, Qt::Key_Return);
    }
    /// Opens the row's menu by its button.
    QMenu* menu(const char* id) const {
        QWidget* found = row(id);
        if (!found) return nullptr;
        QTest::mouseClick(found->findChild<QWidget*>(QStringLiteral("mark")), Qt::LeftButton);
        return panel.findChild<QMenu*>(QStringLiteral("rowMenu"));
    }
    bool choose(const char* id, const char* action) const {
        QMenu* opened = menu(id);
        QAction* entry = opened ? opened->findChild<QAction*>(QLatin1String(action)) : nullptr;
        const bool possible = entry && entry->isEnabled();
        if (possible) entry->trigger();
        delete opened;
        return possible;
    }
    QString help(const char* label = "helpText") const { return panel.findChild<QLabel*>(QLatin1String(label))->text(); }
    /// Saves an image of the panel if TRUNDLE_PICTURES names a folder.
    void picture(const char* name) {
        const QString to = qEnvironmentVariable("TRUNDLE_PICTURES");
        QApplication::processEvents();
        if (!to.isEmpty()) panel.grab().save(to + QLatin1Char('/') + QLatin1String(name) + QStringLiteral(".png"));
    }
};

/// A copy of the text with `from` replaced, for QCOMPARE.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    return at == std::string::npos ? "no " + from : text.replace(at, from.size(), to);
}

} // namespace trundle
