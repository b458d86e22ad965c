// Loading modules and refusing invalid ones.
#include <fstream>

#include "base/platform/read_file.h"
#include "control/elf_reader.h"
#include "control/kinds_json.h"
#include "control/module_file.h"
#include "control/module_kinds.h"
#include "control/module_store.h"

#include <QtTest>

#include <QTemporaryDir>

using namespace trundle;

namespace {
const std::string kModules = std::string(TRUNDLE_BINARY_DIR) + "/tests/modules/";
const std::string kGood = kModules + "controllers/libgood.so";
const std::string kBefore = kModules + "rebuilt/libbefore.so", kAfter = kModules + "rebuilt/libafter.so";

std::string bytesOf(const std::string& path) { return readRegularFile(path).value(); }

/// Diagnostics of loading the modules of an experiment whose text was checked with `registry`.
std::vector<Diagnostic> loaded(const ExperimentSpec& experiment, const Registry& registry) {
    ModuleStore store;
    Diagnostics diagnostics;
    loadModules(experiment, registry, store, diagnostics);
    return diagnostics.all();
}
} // namespace

class ModulesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void distinguishesBrokenLibraries_data() {
        QTest::addColumn<QString>("library");
        QTest::addColumn<int>("code");
        QTest::addColumn<QString>("words");
        const auto row = [](const char* name, const std::string& library, Code code, const char* words) {
            QTest::newRow(name) << QString::fromStdString(library) << static_cast<int>(code) << words;
        };
        row("missing", kModules + "libnone.so", Code::ModuleUnreadable, "libnone.so");
        row("no entry", kModules + "libno_entry.so", Code::ModuleNoEntry, "exports no trundle_module");
        row("wrong magic", kModules + "libwrong_magic.so", Code::ModuleWrongFormat, "not a Trundle module");
        row("newer interface", kModules + "libnewer_abi.so", Code::ModuleVersion, "interface 2.3; this program has 1.");
        row("newer minor interface", kModules + "libnewer_minor.so", Code::ModuleVersion,
            "with this program's SDK, or use a newer Trundle");
        row("a controller with a command", kModules + "libpublishes_command.so", Code::ModuleWrongFormat,
            "kind 'Wrong' has a signal speed that is no output");
        row("a controller with too many numbers", kModules + "libpublishes_too_much.so", Code::ModuleWrongFormat,
            "kind 'Wrong' publishes 1001 numbers; at most 1000 are possible");
        row("missing symbol", kModules + "libmissing_symbol.so", Code::ModuleMissingSymbol,
            "symbol trundle_test_missing_symbol,");
        row("broken kinds", kModules + "libbroken_kinds.so", Code::ModuleWrongFormat, "kind 'Hollow' lacks one of its functions");
        row("throws in describe", kModules + "libthrows_in_describe.so", Code::ModuleNoEntry, "describing its kinds failed");
        row("truncated", made("cut.so", bytesOf(kGood).substr(0, 5000)), Code::ModuleUnreadable, "is cut off: it has 5000 bytes");
        row("truncated in its header", made("cut2.so", bytesOf(kGood).substr(0, 40)), Code::ModuleUnreadable, "is cut off");
        row("truncated at its end", made("cut3.so", bytesOf(kGood).substr(0, bytesOf(kGood).size() - 1)), Code::ModuleUnreadable,
            "is cut off");
        std::string narrow = bytesOf(kGood), foreign = narrow, program = narrow, big = narrow;
        narrow[4] = 1;
        foreign[18] = static_cast<char>(243);
        program[16] = 2;
        big[5] = 2;
        row("32-bit", made("narrow.so", narrow), Code::ModuleWrongFormat, "is a 32-bit library; this program is 64-bit");
        row("another machine", made("foreign.so", foreign), Code::ModuleWrongFormat, "is built for");
        row("a program", made("program.so", program), Code::ModuleWrongFormat, "is a program");
        row("another byte order", made("big.so", big), Code::ModuleWrongFormat, "byte order");
        row("text file", made("text.so", "#!/bin/sh\necho\n"), Code::ModuleWrongFormat, "it starts with \"#!/bin/sh\"");
        row("empty file", made("empty.so", ""), Code::ModuleWrongFormat, "is empty");
        row("a folder", kModules, Code::ModuleUnreadable, "folder");
    }
    void distinguishesBrokenLibraries() {
        QFETCH(QString, library);
        QFETCH(int, code);
        QFETCH(QString, words);
        ModuleStore store;
        const auto module = store.load(library.toStdString());
        QVERIFY(!module.ok());
        QCOMPARE(static_cast<int>(module.error().code), code);
        QVERIFY2(QString::fromStdString(module.error().message).contains(words), module.error().message.c_str());
    }

    /// Any byte of the ELF tables may be wrong: the file is refused or loaded, and nothing crashes before the dynamic loader runs.
    void rejectsDamagedTables() {
        const std::string good = bytesOf(kGood);
        std::uint32_t state = 1;
        for (int i = 0; i < 300; ++i) {
            std::string bad = good;
            for (int k = 0; k < 4; ++k) {
                state = state * 1664525 + 1013904223;
                bad[16 + (state >> 8) % 200] = static_cast<char>(state >> 24);
            }
            (void)checkModuleFile(made("damaged.so", bad));
        }
    }

    void goodModuleListsItsKinds() {
        ModuleStore store;
        const auto module = store.load(kGood);
        QVERIFY2(module.ok(), module.ok() ? "" : module.error().message.c_str());
        QCOMPARE(module.value()->kinds.size(), std::size_t(5));
        const Kind& driver = module.value()->kinds[0];
        QCOMPARE(driver.name, std::string("Driver"));
        QCOMPARE(driver.module, kGood);
        const Property* speed = driver.find("Speed");
        QVERIFY(speed && speed->unit == "m/s" && speed->minimum == 0 && speed->maximum == 2 &&
                speed->defaultValue->numbers == std::vector{0.2});
        QVERIFY(!driver.find("Angle")->defaultValue && driver.find("Angle")->minExclusive);
        QVERIFY(store.find("Driver", TRUNDLE_CONTROLLER) && !store.find("Driver", TRUNDLE_DEVICE));
        QVERIFY(store.find("Thermometer", TRUNDLE_DEVICE) && store.find("Thermometer", TRUNDLE_DEVICE)->act == nullptr);
        QCOMPARE(store.load(kGood).value(), module.value());
    }

    void twoModulesMayNotBringOneKind() {
        ModuleStore store;
        QVERIFY(store.load(kGood).ok());
        const auto twin = store.load(kModules + "libtwin.so");
        QVERIFY(!twin.ok());
        QCOMPARE(twin.error().code, Code::ModuleDuplicateKind);
        QVERIFY(twin.error().message.find("libgood.so") != std::string::npos &&
                twin.error().message.find("libtwin.so") != std::string::npos);
        ModuleStore other;
        QVERIFY(other.load(kModules + "libtwin.so").ok());
    }

    void descriptionFileMatchesModule() {
        const std::string out = made("libgood.so.kinds.json", "old");
        const Status written = writeKindsJson(kGood, out);
        QVERIFY2(written.ok(), written.ok() ? "" : written.error().message.c_str());
        const auto read = kindsFromJson(bytesOf(out), kGood);
        QVERIFY2(read.ok(), read.ok() ? "" : read.error().message.c_str());
        ModuleStore store;
        const auto& kinds = store.load(kGood).value()->kinds;
        QCOMPARE(kindsToJson(read.value()), kindsToJson(kinds));
        for (std::size_t i = 0; i < kinds.size(); ++i)
            for (std::size_t p = 0; p < kinds[i].properties.size(); ++p) {
                const Property &a = kinds[i].properties[p], &b = read.value()[i].properties[p];
                QVERIFY(a.minimum == b.minimum && a.maximum == b.maximum && a.scale == b.scale && a.type == b.type &&
                        a.defaultValue == b.defaultValue);
            }
        const auto device = std::ranges::find(read.value(), std::string("Thermometer"), &Kind::name);
        QVERIFY(device != read.value().end() && device->alternatives.size() == 1);
        QCOMPARE(device->alternatives[0].names, (std::vector<std::string>{"PerDegree", "DegreesPer"}));
        QCOMPARE(device->alternatives[0].likely, std::string("Offset"));
    }

    void brokenDescriptionsAreRefused_data() {
        QTest::addColumn<QString>("text");
        const auto good = QString::fromStdString(kindsToJson({Kind{"Walker", "", Role::Controller, {}, false, {}, {}, {}}}));
        QTest::newRow("empty") << "";
        QTest::newRow("no JSON") << "kinds";
        QTest::newRow("no object") << "[1, 2]";
        QTest::newRow("other format") << QString(good).replace("\"format\": 1", "\"format\": 2");
        QTest::newRow("no name") << QString(good).replace("\"Walker\"", "\"\"");
        QTest::newRow("strange role") << QString(good).replace("controller", "king");
        QTest::newRow("cut") << good.left(good.size() / 2);
        QTest::newRow("field without anything") << QString(good).replace("\"fields\": []", "\"fields\": [{}]");
        Kind choosing{"Chooser", "", Role::Device, {}, false, {Property{"B"}, Property{"C"}}, {}, {}, {{{"B", "C"}, ""}}};
        const auto choice = QString::fromStdString(kindsToJson({choosing}));
        QTest::newRow("a choice of one") << QString(choice).replace(QRegularExpression("\"B\",\\s*\"C\"\\s*\\]"), "\"B\"]");
        QTest::newRow("a choice of nothing it has") << QString(choice).replace(QRegularExpression("\"C\"\\s*\\]"), "\"D\"]");
        choosing.properties[1].required = true;
        QTest::newRow("a choice of what must be") << QString::fromStdString(kindsToJson({choosing}));
        choosing.properties[1].required = false;
        choosing.alternatives[0].likely = "D";
        QTest::newRow("like nothing it has") << QString::fromStdString(kindsToJson({choosing}));
        QTest::newRow("the name of a unit") << QString(good).replace("Walker", "Hz");
        QTest::newRow("deep") << QString(100000, '[');
    }
    void brokenDescriptionsAreRefused() {
        QFETCH(QString, text);
        const auto kinds = kindsFromJson(text.toStdString(), "libx.so");
        QVERIFY(!kinds.ok());
        QCOMPARE(kinds.error().code, Code::ModuleUndescribed);
    }

    /// A file in Python has no description beside it, and is not built.
    void aDescriptionThatIsRefusedSaysWhatHelps() {
        const Kind walker{"Walker", "", Role::Controller, {}, false, {Property{"B"}, Property{"B"}}, {}, {}};
        const std::string twice = kindsToJson({walker});
        const std::string why = " cannot be used ('Walker' has two fields named B); ";
        for (const char* damaged : {"{ \"format\": ", "[]", "{}", "\xff"}) {
            const std::string said = kindsFromJson(damaged, "/p/libx.so").error().message;
            QVERIFY2(said.starts_with("/p/libx.so.kinds.json cannot be used (it is damaged") && said.find("json.ex") == said.npos,
                     said.c_str());
        }
        QCOMPARE(kindsFromJson(twice, "/p/walk.py").error().message, "/p/walk.py" + why + "correct the class in this file");
        QCOMPARE(kindsFromJson(twice, "/p/libx.so").error().message, "/p/libx.so.kinds.json" + why + "build the module again");
    }

    void staleDescriptionIsAWarningAtTheDirective() {
        const std::string library = made("libcopy.so", bytesOf(kGood));
        ExperimentSpec experiment;
        experiment.modules.push_back({"copy", library, SourceRange{0, {5, 9}}});
        experiment.modules.push_back({"gone", "", {}});
        experiment.modules.push_back({"text", made("libtext.so", "text"), SourceRange{0, {15, 19}}});
        QVERIFY(writeKindsJson(library, kindsJsonPath(library)).ok());
        Registry registry;
        const auto kinds = kindsFromJson(bytesOf(kindsJsonPath(library)), library);
        for (const Kind& kind : kinds.value()) QVERIFY(registry.add(kind).ok());
        const auto load = [&] { return loaded(experiment, registry); };
        QCOMPARE(load().size(), std::size_t(1));
        QCOMPARE(load()[0].code, Code::ModuleWrongFormat);
        QCOMPARE(load()[0].range.range.begin, 15u);
        QCOMPARE(load().size(), std::size_t(1));
        std::string changed = bytesOf(kindsJsonPath(library));
        changed.replace(changed.find("Cruising"), 8, "Boozing!");
        made("libcopy.so.kinds.json", changed);
        QCOMPARE(load().size(), std::size_t(2));
        QCOMPARE(load()[0].code, Code::ModuleDescriptionStale);
        QVERIFY(load()[0].severity == Severity::Warning && load()[0].range.range.begin == 5);
    }

    /// A text of help is not what values are checked with.
    void otherHelpIsNoOtherModule() {
        const std::string library = kModules + "publishing/libpublishing.so";
        ExperimentSpec experiment;
        experiment.modules.push_back({"publishing", library, SourceRange{0, {5, 9}}});
        const auto kinds = kindsFromJson(bytesOf(kindsJsonPath(library)), library);
        QVERIFY(kinds.ok());
        const auto loadedWith = [&](void (*change)(Kind&)) {
            Registry registry;
            for (Kind kind : kinds.value()) {
                change(kind);
                if (!registry.add(std::move(kind)).ok()) qFatal("a kind is refused");
            }
            return loaded(experiment, registry).size();
        };
        QVERIFY(std::ranges::any_of(kinds.value(), [](const Kind& kind) { return !kind.signals.empty(); }));
        QCOMPARE(loadedWith([](Kind&) {}), std::size_t(0));
        QCOMPARE(loadedWith([](Kind& kind) { kind.help += "!"; }), std::size_t(0));
        QCOMPARE(loadedWith([](Kind& kind) {
                     for (Property& property : kind.properties) property.help += "!";
                 }),
                 std::size_t(0));
        QCOMPARE(loadedWith([](Kind& kind) {
                     for (SignalDescription& signal : kind.signals) signal.help += "!";
                 }),
                 std::size_t(0));
        QCOMPARE(loadedWith([](Kind& kind) {
                     for (SignalDescription& signal : kind.signals) ++signal.count;
                 }),
                 std::size_t(1));
    }

    void warnsAboutUndescribedModule() {
        ExperimentSpec experiment;
        experiment.modules.push_back({"bare", made("libbare.so", bytesOf(kGood)), {}});
        ModuleStore store;
        Diagnostics diagnostics;
        loadModules(experiment, Registry(), store, diagnostics);
        QVERIFY(diagnostics.all().empty());
    }

    /// The text was read before the module was rebuilt, so its values were checked against outdated ranges.
    void aModuleThatIsAnotherOneThanTheTextWasCheckedWithDoesNotRun() {
        const std::string library = made("libmind.so", bytesOf(kBefore)), description = kindsJsonPath(library);
        made("libmind.so.kinds.json", bytesOf(kindsJsonPath(kBefore)));
        ExperimentSpec experiment;
        experiment.modules.push_back({"mind", library, SourceRange{0, {5, 9}}});
        Registry registry;
        const auto kinds = kindsFromJson(bytesOf(description), library);
        for (const Kind& kind : kinds.value()) QVERIFY(registry.add(kind).ok());
        const auto load = [&] { return loaded(experiment, registry); };
        QVERIFY(load().empty() && !descriptionChanged(experiment, registry));
        ExperimentSpec lacking = experiment;
        lacking.modules.push_back({"lost", {}, {}}); // was not found or did not load, which may have been corrected
        QVERIFY(descriptionChanged(lacking, registry));
        made("libmind.so", bytesOf(kAfter)); // its description is not written yet
        QCOMPARE(load().size(), std::size_t(1));
        QVERIFY(load()[0].severity == Severity::Error && load()[0].code == Code::ModuleDescriptionStale);
        QVERIFY2(load()[0].message.find("build the module again") != std::string::npos, load()[0].message.c_str());
        QVERIFY(!descriptionChanged(experiment, registry));
        made("libmind.so.kinds.json", bytesOf(kindsJsonPath(kAfter)));
        QCOMPARE(load().size(), std::size_t(1));
        QCOMPARE(load()[0].severity, Severity::Error);
        QVERIFY2(load()[0].message.find("was rebuilt: load the experiment again (in the window Ctrl+Shift+R)") !=
                     std::string::npos,
                 load()[0].message.c_str());
        QVERIFY(descriptionChanged(experiment, registry));
    }

    /// Overwritten while it is loaded, as by `cp`: the running copy stays unchanged, the next load gets the new file.
    void aFileWrittenOverWhileItIsLoadedIsTwoModules() {
        const std::string library = made("libswap.so", bytesOf(kBefore));
        ModuleStore running;
        const auto before = running.load(library);
        QVERIFY2(before.ok(), before.ok() ? "" : before.error().message.c_str());
        made("libswap.so", ""); // truncated in place
        made("libswap.so", bytesOf(kAfter));
        const auto most = [](const LoadedModule& module) { return module.descriptor->kinds[0]->fields[0].maximum; };
        QCOMPARE(most(*before.value()), 2.0);
        ModuleStore next; // while the first one does not return
        const auto after = next.load(library);
        QVERIFY2(after.ok(), after.ok() ? "" : after.error().message.c_str());
        QCOMPARE(most(*after.value()), 0.5);
        QCOMPARE(most(*before.value()), 2.0);
    }

    /// Each load has its own state, including symbols that the compiler made unique per process.
    void nothingIsSharedWithAnEarlierLoad() {
        QVERIFY(!ElfReader(bytesOf(kBefore)).uniqueBindings().empty());
        ModuleStore one, two;
        int* const first = static_cast<int*>(one.load(kBefore).value()->code.symbol("trundle_test_lives"));
        int* const second = static_cast<int*>(two.load(kAfter).value()->code.symbol("trundle_test_lives"));
        QVERIFY(first && second && first != second);
    }

    void aModuleFindsTheLibraryBesideIt() {
        const std::string library = kModules + "leaning/libleaning.so", bytes = bytesOf(library);
        QCOMPARE(ElfReader(bytes).searched(), std::string("$ORIGIN"));
        QCOMPARE(ElfReader(bytes).needs()[0], std::string("libtest_beside.so"));
        ModuleStore store;
        const auto module = store.load(library);
        QVERIFY2(module.ok(), module.ok() ? "" : module.error().message.c_str());
        QCOMPARE(module.value()->kinds[0].help, std::string("Leans on 42."));
        QCOMPARE(module.value()->beside.size(), std::size_t(1));
    }

    void everyControllerHasTheCommonFields() {
        Kind controller{"A", "", Role::Controller, {}, false, {}, {}, {}}, device{"B", "", Role::Device, {}, false, {}, {}, {}};
        addControllerFields(controller);
        addControllerFields(device);
        QVERIFY(controller.find("UpdatePeriod") && controller.find("Isolation") && controller.find("Budget"));
        QCOMPARE(controller.find("Isolation")->choices, (std::vector<std::string>{"none", "module", "robot"}));
        QCOMPARE(controller.find("Budget")->unit, std::string("ms"));
        QVERIFY(device.properties.empty());
    }

private:
    std::string made(const std::string& name, const std::string& bytes) {
        const std::string path = m_folder.filePath(QString::fromStdString(name)).toStdString();
        std::ofstream(path, std::ios::binary) << bytes;
        return path;
    }
    QTemporaryDir m_folder;
};

QTEST_APPLESS_MAIN(ModulesTest)
#include "modules_test.moc"
