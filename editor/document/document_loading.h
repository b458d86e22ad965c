#pragma once
#include <functional>
#include <memory>
#include <string>

#include <QObject>

#include "app/application.h"
#include "project/edits/change_set.h"
#include "project/loading/text_overlay.h"

namespace trundle {

struct DocumentState;

/// Loads the texts of a document: all of them after each change, or with other texts to see what they would mean.
class DocumentLoading final : public QObject {
    Q_OBJECT
public:
    using Loaded = std::shared_ptr<const LoadedProject>;
    /// Returns why the changes are rejected; empty if they are accepted.
    using Validator = std::function<std::string(const ChangeSet& changes)>;

    explicit DocumentLoading(DocumentState& state) : m_state(state) {} ///< must outlive this object

    /// Loads the project with these texts in place of the current ones. The document does not change.
    [[nodiscard]] Result<Loaded> with(const TextOverlay& texts) const;
    /// Loads another file of the project with the current texts, and these in place of theirs.
    [[nodiscard]] Result<Loaded> from(const std::string& file, const TextOverlay& texts = {}) const;

    /// Replaces texts and loads them. On failure nothing changes. The caller notifies.
    [[nodiscard]] Status replace(const TextOverlay& texts, const Validator& validate = {});
    /// Loads the same texts, for example after a module or a mesh changed on disk, and notifies.
    void readAgain();
    /// Takes over what was loaded.
    void adopt(Loaded loaded);
    /// Reads meshes and images that are new or changed, in a worker thread; then the texts are loaded again.
    void readNamed();
    void notifyChanged();

Q_SIGNALS:
    void changed(const ChangeSet& changes);

private:
    [[nodiscard]] OpenOptions optionsNow() const;

    DocumentState& m_state;
    bool m_readsNamed = false; ///< a worker thread reads meshes and images
};

} // namespace trundle
