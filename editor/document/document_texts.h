#pragma once
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <QObject>

namespace trundle {

struct DocumentState;

/// The texts of the open project: its files as they are edited here. Paths are absolute.
class DocumentTexts final : public QObject {
    Q_OBJECT
public:
    explicit DocumentTexts(DocumentState& state) : m_state(state) {} ///< must outlive this object

    /// The project's files in the order of FileId; the first is the opened one.
    [[nodiscard]] std::vector<std::string> files() const;
    [[nodiscard]] std::shared_ptr<const std::string> text(const std::string& file) const; ///< null if it is not of this project
    /// Path for display, relative to the project's folder.
    [[nodiscard]] std::string shown(const std::string& file) const;
    /// Whether the file was installed with Trundle. Such a file can be edited here, but only DocumentSaving::saveAs() writes it.
    [[nodiscard]] bool isSample(const std::string& file) const;
    [[nodiscard]] bool isRemoved(const std::string& file) const; ///< an edit created it and was undone: the next save removes it
    [[nodiscard]] bool isModified() const;                       ///< whether any file differs from the disk
    [[nodiscard]] bool isModified(const std::string& file) const;
    [[nodiscard]] std::vector<std::string> modifiedFiles() const; ///< the opened one first
    [[nodiscard]] std::vector<std::string> modifiedSamples() const;

    /// Compares with the last report, and emits modifiedChanged(). Schedules a write of the recovery journal.
    void checkModified();
    void forgetReport() { m_reported.clear(); } ///< another project

Q_SIGNALS:
    void modifiedChanged();

private:
    DocumentState& m_state;
    std::set<std::string> m_reported;
};

} // namespace trundle
