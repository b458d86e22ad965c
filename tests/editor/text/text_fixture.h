#pragma once
// Fixture: a text panel over a real document, in a temporary folder.

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "app/application.h"
#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/text/code/code_edit.h"
#include "editor/text/pages/file_page.h"
#include "editor/text/text_panel.h"
#include "editor/widgets/actions.h"
#include "editor/widgets/theme.h"
#include "eventually.h"

namespace trundle::test {

inline constexpr ActionRow kRows[] = {
    {"edit.undo", "Edit", "Undo", "", "Ctrl+Z", ""},
    {"edit.redo", "Edit", "Redo", "", "Ctrl+Shift+Z", ""},
    {"edit.cut", "Edit", "Cut", "", "Ctrl+X", ""},
    {"edit.copy", "Edit", "Copy", "", "Ctrl+C", ""},
    {"edit.paste", "Edit", "Paste", "", "Ctrl+V", ""},
    {"edit.delete", "Edit", "Delete", "", "Del", ""},
    {"edit.selectAll", "Edit", "All", "", "Ctrl+A", ""},
    {"edit.duplicate", "Edit", "Duplicate", "", "Ctrl+D", ""},
    {"edit.rename", "Edit", "Rename", "", "F2", ""},
    {"edit.find", "Edit", "Find", "", "Ctrl+F", ""},
    {"edit.findInFiles", "Edit", "Find in Files", "", "Ctrl+Shift+F", ""},
    {"edit.replace", "Edit", "Replace", "", "Ctrl+H", ""},
    {"text.complete", "Edit", "Complete", "", "Ctrl+Space", ""},
    {"text.fix", "Edit", "Fix", "", "Alt+Return", ""},
    {"text.definition", "Edit", "Definition", "", "F12", ""},
    {"text.uses", "Edit", "Uses", "", "Shift+F12", ""},
    {"text.comment", "Edit", "Comment", "", "Ctrl+/", ""},
    {"text.lineUp", "Edit", "Up", "", "Alt+Up", ""},
    {"text.lineDown", "Edit", "Down", "", "Alt+Down", ""},
    {"text.format", "Edit", "Format", "", "Ctrl+Shift+I", ""},
    {"text.wrap", "Edit", "Wrap", "", "", "", true},
    {"text.fold", "Edit", "Fold", "", "", ""},
    {"text.unfold", "Edit", "Unfold", "", "", ""},
};

struct TextFixture {
    QTemporaryDir folder;
    std::unique_ptr<Application> application = makeApplication();
    Document document{*application};
    Selection selection;
    Actions actions{kRows};
    TextPanel panel{document, selection, actions};

    /// Writes a file and returns its path.
    std::string write(const char* name, const QByteArray& bytes) {
        const QString path = folder.filePath(QString::fromLatin1(name));
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) qFatal("cannot write %s", name);
        file.close();
        return QFileInfo(path).canonicalFilePath().toStdString();
    }
    /// Opens the file and shows the window with the focus in the text.
    void open(const std::string& path) {
        const Status opened = document.opening().open(path);
        if (!opened) qFatal("%s", opened.error().message.c_str());
        panel.resize(900, 600);
        panel.show();
        panel.activateWindow();
        (void)QTest::qWaitForWindowActive(&panel, kTimeoutMs);
        edit().setFocus();
    }
    [[nodiscard]] FilePage& page() { return *panel.page(); }
    [[nodiscard]] CodeEdit& edit() { return panel.page()->edit(); }
    [[nodiscard]] QByteArray text(const std::string& file) const {
        const auto text = document.texts().text(file);
        return text ? QByteArray::fromStdString(*text) : QByteArray();
    }
    [[nodiscard]] QByteArray text() { return text(page().file()); }
    [[nodiscard]] QByteArray shown() { return QByteArray::fromStdString(edit().bytes()); }
    /// Puts the caret before the first occurrence of `words`, plus an offset.
    void caretAt(const char* words, int plus = 0) {
        const auto at = static_cast<std::uint32_t>(shown().indexOf(words) + plus);
        edit().select({at, at});
        page().endWord();
    }
    void keys(const char* text) {
        for (const QChar c : QString::fromUtf8(text)) {
            if (c < QChar(128)) QTest::keyClick(&edit(), c.toLatin1());
            else QTest::sendKeyEvent(QTest::Click, &edit(), Qt::Key_unknown, QString(c), Qt::NoModifier);
        }
    }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(&edit(), key, modifiers); }
    [[nodiscard]] QStringList history() const {
        QStringList names;
        for (const auto& entry : document.edits().history().entries()) names << entry.name;
        return names;
    }
};

inline constexpr char kDrive[] = R"(// One ball on a floor.
Tick = 0.01
#import parts.sim
Material red { ColorRGB=1,0,0 }
StaticConfig Floor { Plane ground { Material=red } }
Static floor { Config=Floor }
Robot ball {
  Config=Ball
  Pos=0,0,1
}
)";
inline constexpr char kParts[] = R"(RobotConfig Ball {
  Param size = 0.1
  Body body {
    Sphere ball { Radius=$size Mass=1 }
  }
}
)";

inline std::string openDrive(TextFixture& w) {
    (void)w.write("parts.sim", kParts);
    std::string path = w.write("drive.sim", kDrive);
    w.open(path);
    return path;
}

} // namespace trundle::test
