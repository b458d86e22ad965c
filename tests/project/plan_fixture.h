#pragma once
// A fixture that applies edit plans and returns the resulting texts and their resolved experiment.

#include <map>

#include "devices/builtin.h"
#include "lang/tree_edit.h"
#include "project/edits/plans.h"
#include "project/loading/search.h"
#include "run/logs/log_kinds.h"
#include "sample_project.h"

namespace sample {

/// Replaces the shipped controllers, so that these tests do not need them built.
struct DriverController {
    double speed = 0.2, rate = 1, distance = 1, angle = 360, backOff = 0.2, period = 1;
    std::array<double, 2> turn{60, 180};
    std::string drive = "base", touch = "frontTouch";
    static void describe(Describe<DriverController>& d) {
        d.field("Speed", &DriverController::speed, metresPerSecond().within(-10, 10), "Speed.");
        d.field("TurnRate", &DriverController::rate, radiansPerSecond().within(0, 100), "Rate.");
        d.field("Distance", &DriverController::distance, metres(), "Distance.");
        d.field("Angle", &DriverController::angle, degrees(), "Angle.");
        d.field("BackOff", &DriverController::backOff, metres(), "Back off.");
        d.field("Period", &DriverController::period, seconds(), "Period.");
        d.field("TurnAngle", &DriverController::turn, degrees(), "Turn.");
        d.field("Drive", &DriverController::drive, text(), "The drive.");
        d.field("Touch", &DriverController::touch, text(), "The sensor.");
    }
};

class PlanCatalog final : public ModuleCatalog {
public:
    Result<ModuleListing> find(const std::string& written, const std::string&) override {
        ModuleListing listing{"/modules/" + written, true, {}};
        const std::map<std::string, std::string> names{{"walker", "Walker"},
                                                       {"controllers/linear_motion", "LinearMotion"},
                                                       {"controllers/arc_motion", "ArcMotion"},
                                                       {"controllers/bump_and_turn", "BumpAndTurn"},
                                                       {"controllers/random_drive", "RandomDrive"}};
        const auto it = names.find(written);
        if (it == names.end()) {
            if (written == "plugin") listing.kinds = plugin;
            else return Error{Code::ModuleNotFound, written + " is not found"};
            return listing;
        }
        if (written == "walker")
            listing.kinds.push_back(kindOf<Walker>("Walker", Role::Controller, {"Robot", "Grid", "Scatter"}));
        else listing.kinds.push_back(kindOf<DriverController>(it->second, Role::Controller, {"Robot", "Grid", "Scatter"}));
        return listing;
    }
    std::vector<Kind> plugin; ///< kinds of the module `plugin`
};

using Texts = std::map<std::string, std::string>; ///< by absolute path

class PlanFixture {
public:
    PlanFixture() : m_registry(std::make_shared<Registry>()) {
        addModelKinds(*m_registry);
        const bool good = addDeviceKinds(*m_registry).ok() && addLogKinds(*m_registry).ok();
        assert(good);
        (void)good;
        options.resources = TRUNDLE_SOURCE_DIR "/resources";
    }
    std::string path(const std::string& name) const { return canonical(m_dir.path().toStdString()) + "/" + name; }
    /// Files by name below the fixture's folder; `opened` of the first call is the opened file.
    std::shared_ptr<const LoadedProject> open(const std::map<std::string, std::string>& files,
                                              const std::string& opened = "main.sim") {
        Texts texts;
        options.texts.clear();
        for (const auto& [name, text] : files) texts[path(name)] = text;
        m_opened = path(opened);
        return read(texts);
    }
    std::shared_ptr<const LoadedProject> open(const std::string& text) { return open({{"main.sim", text}}); }
    std::shared_ptr<const LoadedProject> read(const Texts& texts) {
        for (const auto& [name, text] : texts) options.texts[name] = std::make_shared<const std::string>(text);
        // The opened file must be on the disk; its bytes come from the overlay.
        std::filesystem::create_directories(std::filesystem::path(m_opened).parent_path());
        std::ofstream(m_opened).flush();
        Project project(m_registry, catalog, m_meshes, options);
        auto result = project.open(m_opened);
        return result.ok() ? result.value() : nullptr;
    }
    static Texts textsOf(const LoadedProject& loaded) {
        Texts texts;
        for (FileId f = 0; f < loaded.trees.size(); ++f) texts[loaded.paths[f]] = std::string(loaded.trees[f]->source().bytes());
        return texts;
    }
    /// The texts after the plan; empty where its edits do not fit.
    static Texts after(const LoadedProject& loaded, const EditPlan& plan) {
        Texts texts = textsOf(loaded);
        for (const auto& [file, edits] : plan.edits) {
            const auto result = applyEdits(*loaded.trees[file], edits);
            if (!result.ok()) return {};
            texts[loaded.paths[file]] = std::string(result.value()->source().bytes());
        }
        return texts;
    }
    /// The text of one file after a plan, or the error message of the plan.
    std::string text(const std::shared_ptr<const LoadedProject>& loaded, const Result<EditPlan>& plan,
                     const std::string& file = "main.sim") {
        if (!plan.ok()) return "refused: " + plan.error().message;
        const Texts texts = after(*loaded, plan.value());
        return texts.count(path(file)) ? texts.at(path(file)) : "no such text";
    }
    std::shared_ptr<const LoadedProject> apply(const std::shared_ptr<const LoadedProject>& loaded, const Result<EditPlan>& plan) {
        return plan.ok() ? read(after(*loaded, plan.value())) : nullptr;
    }
    ProjectOptions options;
    PlanCatalog catalog;

private:
    static std::string canonical(const std::string& path) { return std::filesystem::canonical(path).string(); }
    QTemporaryDir m_dir;
    std::shared_ptr<Registry> m_registry;
    Meshes m_meshes;
    std::string m_opened;
};

} // namespace sample
