#include "app/module_template.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <string_view>

#include "base/clean_text.h"
#include "base/platform/atomic_file.h"
#include "base/platform/read_file.h"
#include "base/units.h"
#include "lang/characters.h"

namespace trundle {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestName = 60;
/// Modules of Python's library (3.11): a file with one of these names would be loaded in its place.
constexpr std::string_view kPythonModules =
    " "
    "abc aifc antigravity argparse array ast asynchat asyncio asyncore atexit audioop base64 bdb binascii bisect "
    "builtins bz2 calendar cgi cgitb chunk cmath cmd code codecs codeop collections colorsys compileall concurrent "
    "configparser contextlib contextvars copy copyreg crypt csv ctypes curses dataclasses datetime dbm decimal "
    "difflib dis distutils doctest email encodings ensurepip enum errno faulthandler fcntl filecmp fileinput fnmatch "
    "fractions ftplib functools gc genericpath getopt getpass gettext glob graphlib grp gzip hashlib heapq hmac html "
    "http idlelib imaplib imghdr imp importlib inspect io ipaddress itertools json keyword lib2to3 linecache locale "
    "logging lzma mailbox mailcap marshal math mimetypes mmap modulefinder msilib msvcrt multiprocessing netrc nis "
    "nntplib nt ntpath nturl2path numbers opcode operator optparse os ossaudiodev pathlib pdb pickle pickletools "
    "pipes pkgutil platform plistlib poplib posix posixpath pprint profile pstats pty pwd py_compile pyclbr pydoc "
    "pydoc_data pyexpat queue quopri random re readline reprlib resource rlcompleter runpy sched secrets select "
    "selectors shelve shlex shutil signal site smtpd smtplib sndhdr socket socketserver spwd sqlite3 sre_compile "
    "sre_constants sre_parse ssl stat statistics string stringprep struct subprocess sunau symtable sys sysconfig "
    "syslog tabnanny tarfile telnetlib tempfile termios textwrap this threading time timeit tkinter token tokenize "
    "tomllib trace traceback tracemalloc tty turtle turtledemo types typing unicodedata unittest urllib uu uuid venv "
    "warnings wave weakref webbrowser winreg winsound wsgiref xdrlib xml xmlrpc zipapp zipfile zipimport zlib "
    "zoneinfo ";
constexpr const char* kNameRule = "a capital letter and then letters, digits and _, like ";

struct Template {
    const char *folder, *kind, *module;
    const char* plain = nullptr; ///< folder of the files that differ for a robot without a drive
};

Template templateOf(ModuleTemplate what) {
    switch (what) {
    case ModuleTemplate::Controller: return {"controller", "MyController", "my_controller", "plain_controller"};
    case ModuleTemplate::PythonController: return {"python", "MyController", "my_controller", "plain_python"};
    case ModuleTemplate::PythonComponent: return {"python_component", "MySensor", "my_sensor"};
    case ModuleTemplate::Component: break;
    }
    return {"component", "MySensor", "my_sensor"};
}

/// The call that gets a drive, in C++ and in Python.
struct DrivePort {
    const char *kind, *cpp, *python;
};
constexpr DrivePort kDrivePorts[] = {{"DifferentialDrive", "differentialDrive", "differential_drive"},
                                     {"SkidDrive", "skidDrive", "skid_drive"},
                                     {"TrackDrive", "trackDrive", "track_drive"},
                                     {"OmniDrive", "omniDrive", "omni_drive"},
                                     {"MecanumDrive", "mecanumDrive", "mecanum_drive"},
                                     {"AckermannDrive", "ackermannDrive", "ackermann_drive"}};

bool isCapital(char c) { return c >= 'A' && c <= 'Z'; }

bool isKindName(const std::string& name) {
    return !name.empty() && name.size() <= kLongestName && isCapital(name[0]) && std::ranges::all_of(name, isIdent);
}

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

/// The circle of the template, for the drive of another robot: a steered one has an angle for its curves, one that moves in all
/// directions a second speed.
std::string forRobot(std::string text, const CommandedRobot& robot) {
    std::vector<std::pair<std::string, std::string>> words;
    if (robot.driveKind == "OmniDrive" || robot.driveKind == "MecanumDrive")
        words = {{"move(speed, turn", "move(speed, 0, turn"}, {"move(self.speed, self", "move(self.speed, 0.0, self"}};
    if (robot.driveKind == "AckermannDrive")
        words = {{"turnRate = 0.5", "steering = 20 * std::numbers::pi / 180"},
                 {"#include <trundle", "#include <numbers>\n\n#include <trundle"},
                 {"\"TurnRate\", 0.5", "\"Steering\", 20 * math.pi / 180"},
                 {"import trundle\n", "import math\n\nimport trundle\n"},
                 {"radiansPerSecond().within(-5, 5)", "degrees().within(-60, 60)"},
                 {"radians_per_second().within(-5, 5)", "degrees().within(-60, 60)"},
                 {"import field, metres_per_second, radians_per_second", "import degrees, field, metres_per_second"},
                 {"Positive turns left.", "Positive steers left."},
                 {"TurnRate", "Steering"},
                 {"turnRate", "steering"},
                 {"turn_rate", "steering"}};
    if (const auto* port = std::ranges::find(kDrivePorts, robot.driveKind, &DrivePort::kind); port != std::end(kDrivePorts)) {
        const std::string name = "(\"" + robot.drive + "\")";
        words.insert(words.end(), {{"DifferentialDrivePort", robot.driveKind + "Port"},
                                   {"differentialDrive(\"base\")", port->cpp + name},
                                   {"differential_drive(\"base\")", port->python + name}});
    }
    words.emplace_back("Config=SimpleRobot", "Config=" + robot.config);
    for (const auto& [from, to] : words) replaceAll(text, from, to);
    return text;
}

/// For a POSIX shell.
std::string quoted(const std::string& path) {
    const auto isPlain = [](char c) { return isIdent(c) || c == '/' || c == '.' || c == '-'; };
    if (!path.empty() && std::ranges::all_of(path, isPlain)) return path;
    std::string text = path;
    replaceAll(text, "'", R"('\'')");
    return "'" + text + "'";
}

Error failure(const std::string& path, const std::string& why) {
    return Error{Code::FileUnreadable, cleanLine(path) + " cannot be made: " + cleanLine(why)};
}

/// The files of a template, by name.
Result<std::map<std::string, std::string>> templateFiles(const Template& from, const CommandedRobot& robot,
                                                         const Locations& locations) {
    std::map<std::string, std::string> files;
    const bool isPlain = from.plain && robot.driveKind.empty();
    for (const char* const folder : {from.folder, isPlain ? from.plain : from.folder}) { // the later ones replace
        const fs::path source = fs::path(locations.templates) / folder;
        std::error_code ec;
        for (fs::directory_iterator it(source, ec), end; !ec && it != end; it.increment(ec)) {
            Result<std::string> text = readRegularFile(it->path().string());
            if (!text) return text.error();
            files.insert_or_assign(it->path().filename().string(), std::move(text).value());
        }
        if (ec || files.empty()) return Error{Code::FileUnreadable, "the templates are not found in " + source.string()};
    }
    return files;
}

} // namespace

std::string kindNameFault(const std::string& kind) {
    if (isKindName(kind)) return {};
    return "a kind cannot be named " + cleanLine(kind) + ": its name is " + kNameRule + "WallFollow";
}

std::string kindNameFault(ModuleTemplate what, const std::string& kind) {
    if (std::string fault = kindNameFault(kind); !fault.empty()) return fault;
    const bool isKeyword = isPython(what) && (kind == "None" || kind == "True" || kind == "False"); // those with a capital letter
    const char* const meaning = findUnit(kind)    ? "a unit"
                                : kind == "Param" ? "a reserved word"
                                : isKeyword       ? "a word of Python"
                                                  : nullptr;
    if (meaning) return "a kind cannot be named " + kind + ": that is " + meaning + ", choose another name";
    const std::string module = moduleNameFor(kind);
    if (isPython(what) && (module == "trundle" || kPythonModules.find(" " + module + " ") != std::string_view::npos))
        return "a kind in Python cannot be named " + kind + ": its file " + module + ".py would hide the module " + module +
               " of Python, choose another name";
    return {};
}

std::string configNameFault(const std::string& what, const std::string& name, const std::string& like,
                            const std::string& imported) {
    if (name.empty()) return what + " needs a name: " + kNameRule + like;
    const std::string start = what + " cannot be named " + cleanLine(name) + ": ";
    if (!isKindName(name)) return start + "its name is " + kNameRule + like;
    if (name == "Param") return start + "that is a reserved word, choose another name";
    if (name == imported) return start + "its experiment imports a config of that name, choose another name";
    return {};
}

CommandedRobot commandedRobot(const RobotConfigSpec& config) {
    for (const ComponentSpec& device : config.devices)
        if (std::ranges::find(kDrivePorts, device.kind, &DrivePort::kind) != std::end(kDrivePorts))
            return {config.name, device.kind, device.name};
    return {config.name, {}, {}};
}

std::string moduleNameFor(const std::string& kind) {
    std::string name;
    for (std::size_t i = 0; i < kind.size(); ++i) {
        const bool begins = i > 0 && isCapital(kind[i]) && kind[i - 1] != '_' &&
                            (!isCapital(kind[i - 1]) || (i + 1 < kind.size() && kind[i + 1] >= 'a' && kind[i + 1] <= 'z'));
        if (begins) name += '_';
        name += isCapital(kind[i]) ? static_cast<char>(kind[i] - 'A' + 'a') : kind[i];
    }
    return name;
}

Result<NewModule> makeModule(ModuleTemplate what, const std::string& kind, const std::string& parent, const Locations& locations,
                             const CommandedRobot& robot) {
    if (const std::string fault = kindNameFault(what, kind); !fault.empty()) return Error{Code::FileUnreadable, fault};
    const Template from = templateOf(what);
    const std::string module = moduleNameFor(kind);
    const fs::path folder = fs::path(parent) / module;
    std::error_code ec;
    Result<std::map<std::string, std::string>> read = templateFiles(from, robot, locations);
    if (!read) return read.error();
    std::map<std::string, std::string> files; // by name
    for (const auto& [fileName, written] : read.value()) {
        std::string name = fileName, text = from.plain ? forRobot(written, robot) : written;
        for (std::string* words : {&name, &text}) {
            replaceAll(*words, from.kind, kind);
            replaceAll(*words, from.module, module);
        }
        files.emplace(std::move(name), std::move(text));
    }

    if (!fs::create_directory(folder, ec))
        return failure(folder.string(), ec ? ec.message() : std::string("it exists; choose another name or folder"));
    NewModule made;
    made.folder = folder.string();
    made.load = "#loadModule " + module + "/build/" + module;
    made.source = (folder / (module + ".cpp")).string();
    made.library = (folder / "build" / ("lib" + module + ".so")).string();
    for (const auto& [name, text] : files) {
        if (const Status written = writeFileAtomically((folder / name).string(), text); !written) {
            fs::remove_all(folder, ec); // made above, so all in it is ours
            return written.error();
        }
        made.files.push_back(name);
    }
    if (isPython(what)) {
        made.load = "#loadModule " + module + '/' + module + ".py";
        made.source = made.library = (folder / (module + ".py")).string();
        return made;
    }
    const std::string shown = quoted(folder.string());
    made.configure = "cmake -S " + shown + " -B " + shown +
                     "/build -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH=" + quoted(locations.sdkPackage);
    made.build = "cmake --build " + shown + "/build";
    return made;
}

} // namespace trundle
