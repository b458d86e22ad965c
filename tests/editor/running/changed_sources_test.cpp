// A run with a module in C++ whose source was changed after the module was built.
#include <QSettings>
#include <QSignalSpy>
#include <QtTest>

#include "editor/running/session_fixture.h"
#include "eventually.h"

using namespace trundle;

namespace {

const QString kShipped = QStringLiteral(TRUNDLE_BINARY_DIR "/lib/trundle/controllers/liblinear_motion");
const QByteArray kText = "#import robots/simple_robot.sim\n#loadModule walk/build/walk\nTick = 0.01\n"
                         "Robot rover { Config=SimpleRobot LinearMotion brain { } }\n";

/// A project with a module in the folder walk, built an hour after its source was written.
struct Trial : SessionFixture {
    Trial() {
        OpenOptions options;
        options.trust = true;
        document.setOptions(options);
        QDir(folder.path()).mkpath(QStringLiteral("walk/build"));
        for (const char* extension : {".so", ".so.kinds.json"})
            if (!QFile::copy(kShipped + QLatin1String(extension), path("walk/build/libwalk") + QLatin1String(extension)))
                qFatal("cannot copy the module");
        write("walk/CMakeLists.txt");
        write("walk/walk.cpp");
        QObject::connect(&document, &Document::notice, [this](const QString& text) { notices += text; });
    }
    /// `hours`: after the module was built.
    void write(const char* name, int hours = -1) const {
        QFile file(path(name));
        if (!file.open(QIODevice::WriteOnly) || file.write("// source\n") < 0 || !file.flush()) qFatal("cannot write");
        const QDateTime built = QFileInfo(path("walk/build/libwalk.so")).lastModified();
        if (!file.setFileTime(built.addSecs(3600 * hours), QFileDevice::FileModificationTime)) qFatal("cannot set the time");
    }
    QStringList notices;
};

} // namespace

class ChangedSourcesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() { QSettings().clear(); }

    void aModuleThatWasBuiltSinceRunsWithoutANotice() {
        Trial p;
        p.write("walk/notes.txt", 1); // no source
        p.write("other.cpp", 1);      // of no module
        QVERIFY(p.open(kText));
        p.session.run();
        QCOMPARE(p.session.state(), RunState::Building);
        QCOMPARE(p.notices, QStringList());
        EVENTUALLY(p.tick() > 1);
    }

    void aSourceThatIsNewerOnDiskIsNamed() {
        Trial p;
        p.write("walk/walk.cpp", 1);
        QVERIFY(p.open(kText));
        p.session.run();
        QCOMPARE(p.notices,
                 QStringList{QStringLiteral("Runs a module that was built before walk/walk.cpp was changed; Ctrl+B builds it")});
        EVENTUALLY(p.tick() > 1);
    }

    void aSourceWithUnsavedEditsIsNamed() {
        Trial p;
        QVERIFY(p.open(kText));
        const std::string source = QDir(p.folder.path()).canonicalPath().toStdString() + "/walk/walk.cpp";
        QVERIFY(p.document.edits().addText(source).ok());
        const auto text = std::make_shared<const std::string>("// other\n");
        QVERIFY(p.document.edits().replaceTexts(QStringLiteral("Typing"), {{source, text}}).ok());
        p.session.run();
        QCOMPARE(p.notices.size(), 1);
        QVERIFY2(p.notices.first().contains(QStringLiteral("before walk/walk.cpp was changed")), qPrintable(p.notices.first()));
        EVENTUALLY(p.tick() > 1);
    }
};

QTEST_MAIN(ChangedSourcesTest)
#include "changed_sources_test.moc"
