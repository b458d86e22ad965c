#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <QObject>

#include "base/platform/read_file.h"
#include "editor/document/disk_watch.h"

namespace trundle {

class Application;
class Document;

/// Reports that files of the modules in Python have changed on disk: saved here or by another program, open in a tab or not, also those of
/// a module that did not load.
class PythonWatch final : public QObject {
    Q_OBJECT
public:
    /// Both must outlive this object.
    PythonWatch(Document& document, const Application& application, QObject* parent);

Q_SIGNALS:
    void changed();

private:
    using Stamps = std::map<std::string, std::optional<FileStamp>>; // by path; none: it is not there

    void follow();
    void look();
    [[nodiscard]] std::vector<std::string> modules() const;
    [[nodiscard]] Stamps stamps() const;
    void watch(Stamps now);

    Document& m_document;
    const Application& m_application;
    DiskWatch m_disk;
    std::vector<std::string> m_modules; // Python files that the experiment loads
    Stamps m_known;                     // of them and of those beside them, which they may import
};

} // namespace trundle
