#include "trundle/options.h"

#include <cstdlib>

#include <QCommandLineParser>
#include <QFileInfo>

#include "trundle/problem.h"

namespace trundle {
namespace {

[[noreturn]] void refuse(const QString& message) {
    printProblem(message);
    std::exit(2);
}

/// The values of an option that names existing folders.
std::vector<std::string> folders(const QCommandLineParser& parser, const QString& option) {
    std::vector<std::string> all;
    for (const QString& folder : parser.values(option)) {
        const QString dashes = option.size() == 1 ? QStringLiteral("-") : QStringLiteral("--");
        if (!QFileInfo(folder).isDir()) refuse(QStringLiteral("%1%2: there is no folder %3").arg(dashes, option, folder));
        all.push_back(QFileInfo(folder).absoluteFilePath().toStdString());
    }
    return all;
}

QSize sizeFrom(const QString& text) {
    const QStringList sides = text.split(QLatin1Char('x'));
    const QSize size = sides.size() == 2 ? QSize(sides[0].toInt(), sides[1].toInt()) : QSize();
    if (size.width() < 320 || size.height() < 240 || size.width() > 8192 || size.height() > 8192)
        refuse(QStringLiteral("--size takes WIDTHxHEIGHT from 320x240 to 8192x8192, not %1").arg(text));
    return size;
}

/// The value of an option that accepts one of a few words.
QString oneOf(const QCommandLineParser& parser, const QString& option, const QStringList& words) {
    const QString value = parser.value(option).toLower();
    if (!value.isEmpty() && !words.contains(value))
        refuse(QStringLiteral("--%1 is one of %2, not %3").arg(option, words.join(QStringLiteral(", ")), value));
    return value;
}

void describeOptions(QCommandLineParser& parser) {
    parser.setApplicationDescription(QStringLiteral(
        "Trundle: build robots and arenas, run them in 3D, watch and measure.\n\n"
        "Exit codes with --quit: 0 done, 1 FILE did not run (errors in its text, a module that is not trusted), 2 wrong "
        "usage, a FILE that cannot be read or a picture that cannot be written, 3 the run ended early (it blew up, or a "
        "controller failed or is not responding), 4 code of a module ended the program. With 1 and 3 the picture is taken all "
        "the same."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(QStringLiteral("FILE"), QStringLiteral("An experiment, robot or arena to open."),
                                 QStringLiteral("[FILE]"));
    parser.addOptions(
        {{QStringLiteral("open"), QStringLiteral("Open FILE."), QStringLiteral("FILE")},
         {QStringLiteral("I"), QStringLiteral("Also look for imported files in DIR (may be repeated)."), QStringLiteral("DIR")},
         {QStringLiteral("modules"), QStringLiteral("Also look for modules in DIR, and trust those there (may be repeated)."),
          QStringLiteral("DIR")},
         {QStringLiteral("trust"), QStringLiteral("Trust the modules that lie beside the experiment's files.")},
         {QStringLiteral("run-for"), QStringLiteral("Run for S simulated seconds, then pause."), QStringLiteral("S")},
         {QStringLiteral("view"), QStringLiteral("perspective, top, front, side, follow, chase, text, or a View of FILE."),
          QStringLiteral("NAME")},
         {QStringLiteral("select"), QStringLiteral("Select an object, as robot0 or robot0.chassis (may be repeated)."),
          QStringLiteral("PATH")},
         {QStringLiteral("layout"), QStringLiteral("Docks for edit or run."), QStringLiteral("NAME")},
         {QStringLiteral("theme"), QStringLiteral("light or dark."), QStringLiteral("NAME")},
         {QStringLiteral("look"), QStringLiteral("automatic, fast or rich: how 3D views are drawn."), QStringLiteral("NAME")},
         {QStringLiteral("size"), QStringLiteral("Size of the window in logical pixels."), QStringLiteral("WxH")},
         {QStringLiteral("screenshot"), QStringLiteral("Write a picture of the window to OUT.png once all is drawn."),
          QStringLiteral("OUT")},
         {QStringLiteral("quit"), QStringLiteral("Then quit.")}});
}

} // namespace

WindowOptions readOptions(const QCoreApplication& application) {
    QCommandLineParser parser;
    describeOptions(parser);
    if (!parser.parse(application.arguments())) refuse(parser.errorText());
    parser.process(application); // handles --help and --version

    WindowOptions options;
    options.open = parser.value(QStringLiteral("open"));
    if (parser.positionalArguments().size() > 1) refuse(QStringLiteral("one FILE at a time"));
    if (options.open.isEmpty() && !parser.positionalArguments().isEmpty()) options.open = parser.positionalArguments().front();
    options.given.includes = folders(parser, QStringLiteral("I"));
    options.given.modules = folders(parser, QStringLiteral("modules"));
    options.given.trust = parser.isSet(QStringLiteral("trust"));
    if (parser.isSet(QStringLiteral("run-for"))) {
        bool number = false;
        options.runFor = parser.value(QStringLiteral("run-for")).toDouble(&number);
        if (!number || !(*options.runFor >= 0) || *options.runFor > 1e9)
            refuse(QStringLiteral("--run-for takes seconds from 0 to 1e9"));
    }
    if (options.runFor && options.open.isEmpty()) refuse(QStringLiteral("--run-for needs a FILE to run"));
    options.view = parser.value(QStringLiteral("view"));
    options.select = parser.values(QStringLiteral("select"));
    if (const QString layout = oneOf(parser, QStringLiteral("layout"), {QStringLiteral("edit"), QStringLiteral("run")});
        !layout.isEmpty())
        options.layout = layout == QStringLiteral("run") ? Layout::Run : Layout::Edit;
    if (const QString theme = oneOf(parser, QStringLiteral("theme"), {QStringLiteral("light"), QStringLiteral("dark")});
        !theme.isEmpty())
        options.theme = theme == QStringLiteral("dark") ? ThemeKind::Dark : ThemeKind::Light;
    options.look =
        oneOf(parser, QStringLiteral("look"), {QStringLiteral("automatic"), QStringLiteral("fast"), QStringLiteral("rich")});
    if (parser.isSet(QStringLiteral("size"))) options.size = sizeFrom(parser.value(QStringLiteral("size")));
    options.screenshot = parser.value(QStringLiteral("screenshot"));
    options.quit = parser.isSet(QStringLiteral("quit"));
    return options;
}

} // namespace trundle
