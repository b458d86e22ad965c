// Modules of the user's own: where their sources are, how they are built, and what the output of a build says.

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include "app/compiler_messages.h"
#include "app/module_build.h"
#include "app/module_template.h"
#include "project/loading/loaded_project.h"

using namespace trundle;

class ModuleBuildTest final : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void readsLines_data() {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<QByteArray>("read"); // kind file line column text; empty: no message
        QTest::newRow("gcc") << QByteArray("/p/wall.cpp:12:5: error: 'x' was not declared in this scope")
                             << QByteArray("0 /p/wall.cpp 12 5 'x' was not declared in this scope");
        QTest::newRow("clang warning") << QByteArray("../wall.cpp:3:1: warning: unused variable 'a' [-Wunused-variable]")
                                       << QByteArray("1 ../wall.cpp 3 1 unused variable 'a' [-Wunused-variable]");
        QTest::newRow("fatal") << QByteArray("a b.cpp:1:10: fatal error: none.h: No such file or directory")
                               << QByteArray("0 a b.cpp 1 10 none.h: No such file or directory");
        QTest::newRow("note") << QByteArray("a.cpp:7:3: note: declared here") << QByteArray("2 a.cpp 7 3 declared here");
        QTest::newRow("linker with a line") << QByteArray("/usr/bin/ld: /p/a.cpp:9: undefined reference to `f()'")
                                            << QByteArray("0 /p/a.cpp 9 0 undefined reference to `f()'");
        QTest::newRow("linker") << QByteArray("a.cpp:(.text+0x12): undefined reference to `f()'")
                                << QByteArray("0  0 0 undefined reference to `f()'");
        QTest::newRow("lld") << QByteArray("ld.lld: error: undefined symbol: f()") << QByteArray("0  0 0 undefined symbol: f()");
        QTest::newRow("cmake") << QByteArray("CMake Error at CMakeLists.txt:4 (find_package):") << QByteArray("0 CMakeLists.txt 4 0 ");
        QTest::newRow("cmake warning") << QByteArray("CMake Warning (dev) at CMakeLists.txt:2 (x):")
                                       << QByteArray("1 CMakeLists.txt 2 0 ");
        QTest::newRow("progress") << QByteArray("[ 50%] Building CXX object CMakeFiles/module_wall.dir/wall.cpp.o") << QByteArray();
        QTest::newRow("context") << QByteArray("   12 |     x = 3;") << QByteArray();
        QTest::newRow("in function") << QByteArray("/p/wall.cpp: In function 'int f()':") << QByteArray();
        QTest::newRow("time") << QByteArray("ended at 12:13:14: error") << QByteArray();
        QTest::newRow("huge number") << QByteArray("a.cpp:99999999999999:1: error: x")
                                     << QByteArray("0 a.cpp:99999999999999 1 0 x"); // of a file that does not exist

        QTest::newRow("twice") << QByteArray(
                                      "/usr/bin/ld: /p/a: b.cpp:9: multiple definition of `f()'; x.cpp:3: first defined here")
                               << QByteArray("0 b.cpp 9 0 multiple definition of `f()'; x.cpp:3: first defined here");
        QTest::newRow("without a file") << QByteArray(":12: error: x") << QByteArray();
        QTest::newRow("of another system") << QByteArray("a.cpp:1:2: error: x\r") << QByteArray("0 a.cpp 1 2 x");
        QTest::newRow("cmake text in the line")
            << QByteArray("CMake Error: the source is gone") << QByteArray("0  0 0 the source is gone");

        QTest::newRow("empty") << QByteArray() << QByteArray();
    }
    void readsLines() {
        QFETCH(QByteArray, line);
        const auto message = compilerMessage(line.toStdString());
        const QByteArray read = message ? QByteArray::number(int(message->kind)) + ' ' + message->file.c_str() + ' ' +
                                              QByteArray::number(message->line) + ' ' + QByteArray::number(message->column) + ' ' +
                                              message->text.c_str()
                                        : QByteArray();
        QTEST(read, "read");
    }

    void givesPlaces() {
        write("m/a.cpp", "int a;\n\tint b = colour;\n");
        write("m/CMakeLists.txt", "project(m)\nfind_package(None REQUIRED)\n");
        const std::string project = path(""), output = "../a.cpp:2:10: error: 'colour' was not declared\n"
                                                       "../a.cpp:1:5: note: 'a' declared here\n"
                                                       "../a.cpp:2:10: error: 'colour' was not declared\n"
                                                       "../a.cpp:1:5: note: 'a' declared here\n" // of the repeated one
                                                       "/usr/include/stdio.h:1:1: error: elsewhere\n"
                                                       "../a.cpp:900:1: warning: beyond the end\n"
                                                       "CMake Error at ../CMakeLists.txt:2 (find_package):\n"
                                                       "\n"
                                                       "  None is not found\n";
        const BuildMessages made =
            readBuildOutput(output, path("m/build"), project, [&](const std::string& file) { return file.starts_with(project); });
        QCOMPARE(made.found.size(), std::size_t(4));
        const Diagnostic& first = made.found[0];
        QCOMPARE(made.sources->paths.at(first.range.file), path("m/a.cpp"));
        QCOMPARE(made.sources->sources.slice(first.range), std::string_view("colour"));
        QCOMPARE(first.notes.size(), std::size_t(1));
        QCOMPARE(made.sources->sources.slice(first.notes[0].second), std::string_view("a"));
        QVERIFY(!made.found[1].range.known() && made.found[1].message == "elsewhere");
        QVERIFY(!made.found[2].range.known() && made.found[2].severity == Severity::Warning);
        QCOMPARE(made.found[3].message, std::string("None is not found"));
        QCOMPARE(made.sources->paths.at(made.found[3].range.file), path("m/CMakeLists.txt"));
        QCOMPARE(made.sources->sources[made.found[3].range.file].text->position(made.found[3].range.range.begin).line, 2u);
    }

    void findsTheFolderOfASource() {
        write("mods/wall/CMakeLists.txt", "");
        write("mods/wall/build/CMakeCache.txt", "");
        const std::string project = path("").substr(0, path("").size() - 1);
        QCOMPARE(moduleFolderOf(path("mods/wall/src/deep/a.cpp"), project), path("mods/wall"));
        QCOMPARE(moduleFolderOf(path("mods/wall/build/libwall.so"), project), path("mods/wall"));
        write("mods/wall/build/_deps/x-subbuild/CMakeLists.txt", ""); // as a build itself makes it
        write("mods/wall/build/_deps/x-subbuild/CMakeCache.txt", "");
        QCOMPARE(moduleFolderOf(path("mods/wall/build/_deps/x-subbuild/a.cpp"), project), path("mods/wall"));
        QCOMPARE(moduleFolderOf(path("mods/a.cpp"), project), std::string());
        QCOMPARE(moduleFolderOf(path("mods/wall/a.cpp"), path("mods/other")), std::string()); // of another project
        QCOMPARE(moduleFolderOf(path("mods/wall/a.cpp"), path("mods/wal")), std::string());
        QCOMPARE(moduleFolderOf(std::string(), project), std::string());
        write("mods/wall/a.cpp", "");
        write("mods/wall/wall.h", "");
        write("mods/wall/notes.md", "");
        const std::string library = path("mods/wall/build/libwall.so");
        const std::vector<std::string> sources{path("mods/wall/CMakeLists.txt"), path("mods/wall/a.cpp"),
                                               path("mods/wall/wall.h")};
        QCOMPARE(sourcesOfModule(library, project), sources);
        QVERIFY(sourcesOfModule(library, path("mods/other")).empty() && sourcesOfModule(path("mods/a.py"), project).empty());
    }

    void configuresOnce() {
        const Locations places = findLocations();
        QCOMPARE(buildSteps(path("new"), places).size(), std::size_t(2));
        write("new/build/CMakeCache.txt", ""); // as an interrupted configuration leaves it
        QCOMPARE(buildSteps(path("new"), places).size(), std::size_t(2));
        write("new/build/Makefile", "");
        QCOMPARE(buildSteps(path("new"), places).size(), std::size_t(1));
    }

    void namesModules() {
        QCOMPARE(moduleNameFor("WallFollow"), std::string("wall_follow"));
        QCOMPARE(moduleNameFor("LEDRing"), std::string("led_ring"));
        for (const char* bad : {"", "wall", "2D", "Wall Follow", "Wänd", "A/B"}) QVERIFY2(!kindNameFault(bad).empty(), bad);
        QVERIFY(kindNameFault("WallFollow2").empty());
        QVERIFY(kindNameFault("Wall_Run2").empty());
        QVERIFY(kindNameFault("wall").find("letters, digits and _") != std::string::npos);
        for (const ModuleTemplate what : {ModuleTemplate::Controller, ModuleTemplate::PythonComponent}) {
            for (const char* word : {"V", "Hz", "Param"}) QVERIFY2(!kindNameFault(what, word).empty(), word);
            QCOMPARE(kindNameFault(what, "None").empty(), !isPython(what));
            QVERIFY(kindNameFault(what, "Volt").empty() && !kindNameFault(what, "wall").empty());
            for (const char* hides :
                 {"Trundle", "Abc", "Random", "Xdrlib", "Zoneinfo"}) // files that Python would load in place of modules
                QCOMPARE(kindNameFault(what, hides).empty(), !isPython(what));
            QVERIFY(kindNameFault(what, "Rand").empty() && kindNameFault(what, "TrundleBot").empty());
        }
        QVERIFY(!makeModule(ModuleTemplate::Controller, "V", path(""), findLocations()).ok());
        QVERIFY(!QFile::exists(QString::fromStdString(path("v"))));
        const auto made = makeModule(ModuleTemplate::PythonController, "Wander", path(""), findLocations());
        QVERIFY(made.ok() && made.value().source == path("wander/wander.py") && QFile::exists(QString::fromStdString(made.value().source)));
        QVERIFY(!makeModule(ModuleTemplate::Controller, "Wander", path(""), findLocations()).ok()); // nothing is replaced
    }

    /// The last line of a file has a place; the same words as error and as warning are two; of many messages the first 200.
    void listsMessages() {
        write("m/b.cpp", "int a;\nint b;");
        const auto read = [&](const std::string& output) {
            return readBuildOutput(output, path("m"), path(""), [](const std::string&) { return true; });
        };
        const BuildMessages last =
            read("b.cpp:2:5: error: b\nb.cpp:2:5: warning: b\nb.cpp:3:1: error: none\nb.cpp:1:1: error: a\n"
                 "b.cpp:2: error: without a column\n");
        QCOMPARE(last.found.size(), std::size_t(5));
        QCOMPARE(last.sources->sources.slice(last.found[0].range), std::string_view("b"));
        QVERIFY(!last.found[2].range.known());
        QCOMPARE(last.sources->sources.slice(last.found[3].range), std::string_view("int"));
        QCOMPARE(last.sources->sources.slice(last.found[4].range), std::string_view("int"));
        std::string many;
        for (int i = 0; i < 201; ++i) many += "b.cpp:1:1: error: number " + std::to_string(i) + "\n";
        QCOMPARE(read(many).found.size(), std::size_t(200));
        QCOMPARE(read(many + "b.cpp:1:1: note: of the last\n").found.back().notes.size(), std::size_t(0));
    }

    void aBuildByNinjaIsConfigured() {
        write("ninja/build/build.ninja", "");
        const auto steps = buildSteps(path("ninja"), findLocations());
        QCOMPARE(steps.size(), std::size_t(1));
        QCOMPARE(steps[0][1], path("ninja/build"));
        write("mods2/CMakeLists.txt", "");
        QVERIFY(QDir().mkpath(QString::fromStdString(path("mods2/folder.cpp"))));
        QCOMPARE(sourcesOfModule(path("mods2/x.so"), path("mods2")), std::vector<std::string>{path("mods2/CMakeLists.txt")});
    }

    void namesOfFilesAndConfigs() {
        for (const auto& [kind, module] : {std::pair("Wall_Run", "wall_run"),
                                           {"LEDz", "le_dz"},
                                           {"A", "a"},
                                           {"AB", "ab"},
                                           {"ABc", "a_bc"},
                                           {"Robot2D", "robot2_d"}})
            QCOMPARE(moduleNameFor(kind), std::string(module));
        QVERIFY(kindNameFault("W" + std::string(59, 'a')).empty() && !kindNameFault("W" + std::string(60, 'a')).empty());
        const auto fault = [](const char* name) { return configNameFault("a robot", name, "Rover", "OpenFloor"); };
        QCOMPARE(fault("Rover2"), std::string());
        for (const auto& [name, words] : {std::pair("", "a robot needs a name"),
                                          {"Param", "a reserved word"},
                                          {"OpenFloor", "imports a config of that name"},
                                          {"rover", "its name is a capital letter"}})
            QVERIFY2(fault(name).find(words) != std::string::npos, name);
    }

    /// Paths with blanks and quotes are one word of a shell; a kind may contain its own template's name.
    void commandLinesAreForAShell() {
        QVERIFY(QDir().mkpath(QString::fromStdString(path("it's here"))));
        const auto made = makeModule(ModuleTemplate::Controller, "MyControllerTwo", path("it's here"), findLocations());
        QVERIFY2(made.ok(), made.ok() ? "" : made.error().message.c_str());
        const std::string folder = path("it's here/my_controller_two");
        QVERIFY(made.value().folder == folder && made.value().library == folder + "/build/libmy_controller_two.so");
        QVERIFY(std::ranges::is_sorted(made.value().files));
        const std::string shown = "'" + path("it'\\''s here/my_controller_two") + "'";
        QCOMPARE(made.value().build, "cmake --build " + shown + "/build");
        QFile source(QString::fromStdString(made.value().source));
        QVERIFY(source.open(QIODevice::ReadOnly));
        const QByteArray text = source.readAll();
        QVERIFY(text.contains("MyControllerTwo") && !text.contains("MyControllerTwoTwo"));
    }

    void controllersForDrives_data() {
        QTest::addColumn<QByteArray>("drive"); // kind and name
        QTest::addColumn<QByteArray>("cpp");
        QTest::addColumn<QByteArray>("python");
        QTest::newRow("none") << QByteArray() << QByteArray("Seconds) override {}") << QByteArray("pass");
        QTest::newRow("skid") << QByteArray("SkidDrive d") << QByteArray("skidDrive(\"d\")|SkidDrivePort|move(speed, turnRate)")
                              << QByteArray("skid_drive(\"d\")|move(self.speed, self.turn_rate)");
        QTest::newRow("tracks") << QByteArray("TrackDrive base") << QByteArray("trackDrive(\"base\")|TrackDrivePort")
                                << QByteArray("track_drive(\"base\")");
        QTest::newRow("omni") << QByteArray("OmniDrive base")
                              << QByteArray("omniDrive(\"base\")|OmniDrivePort|move(speed, 0, turnRate)")
                              << QByteArray("omni_drive(\"base\")|move(self.speed, 0.0, self.turn_rate)");
        QTest::newRow("mecanum") << QByteArray("MecanumDrive base")
                                 << QByteArray("mecanumDrive(\"base\")|MecanumDrivePort|speed, 0, turn")
                                 << QByteArray("mecanum_drive(\"base\")|self.speed, 0.0, self.turn");
        QTest::newRow("steered") << QByteArray("AckermannDrive car")
                                 << QByteArray("ackermannDrive(\"car\")|AckermannDrivePort|"
                                               "move(speed, steering)|&Left::steering, trundle::degrees()")
                                 << QByteArray(
                                        "ackermann_drive(\"car\")|move(self.speed, self.steering)|import degrees, field, metres");
    }
    /// A new controller commands what its robot has.
    void controllersForDrives() {
        QFETCH(QByteArray, drive);
        QFETCH(QByteArray, cpp);
        QFETCH(QByteArray, python);
        RobotConfigSpec config;
        config.name = "Wagen";
        config.devices.push_back({"RotaryMotor", "left", {}, {}, {}});
        if (!drive.isEmpty())
            config.devices.push_back({drive.split(' ')[0].toStdString(), drive.split(' ')[1].toStdString(), {}, {}, {}});
        const CommandedRobot robot = commandedRobot(config);
        for (const ModuleTemplate what : {ModuleTemplate::Controller, ModuleTemplate::PythonController}) {
            const std::string parent = path(QTest::currentDataTag()) + (isPython(what) ? "_py" : "_cpp");
            QVERIFY(QDir().mkpath(QString::fromStdString(parent)));
            const auto made = makeModule(what, "Left", parent, findLocations(), robot);
            QVERIFY(made.ok());
            QCOMPARE(made.value().files.size(), isPython(what) ? std::size_t(1) : std::size_t(2));
            QFile source(QString::fromStdString(made.value().source));
            QVERIFY(source.open(QIODevice::ReadOnly));
            const QByteArray text = source.readAll();
            for (const QByteArray& word : (isPython(what) ? python : cpp).split('|'))
                QVERIFY2(text.contains(word), word + " in\n" + text);
            QVERIFY2(text.contains("Config=Wagen  Left brain") && !text.contains("ifferential"), text);
        }
    }

private:
    [[nodiscard]] std::string path(const char* name) const {
        return (QDir(m_folder.path()).canonicalPath() + u'/' + QLatin1String(name)).toStdString();
    }
    void write(const char* name, const QByteArray& bytes) const {
        const QString file = QString::fromStdString(path(name));
        QVERIFY(QDir().mkpath(QFileInfo(file).path()));
        QFile out(file);
        QVERIFY(out.open(QIODevice::WriteOnly));
        out.write(bytes);
    }

    QTemporaryDir m_folder;
};

QTEST_MAIN(ModuleBuildTest)
#include "module_build_test.moc"
