#include "editor/document/document.h"

#include "editor/document/document_state.h"

namespace trundle {

Document::Document(Application& application, QObject* parent)
    : QObject(parent), m_state(std::make_unique<DocumentState>(application)), m_texts(std::make_unique<DocumentTexts>(*m_state)),
      m_loading(std::make_unique<DocumentLoading>(*m_state)), m_access(std::make_unique<ProjectAccess>(*m_state)),
      m_edits(std::make_unique<DocumentEdits>(*m_state, *m_texts, *m_loading, *m_access)),
      m_opening(std::make_unique<ProjectOpening>(*m_state, *m_texts, *m_loading, *m_access, *m_edits)),
      m_disk(std::make_unique<ExternalChanges>(*m_state, *m_texts, *m_loading, *m_access, *m_edits)),
      m_recovery(std::make_unique<DocumentRecovery>(*m_state, *m_texts, *m_edits, *m_disk, *m_opening)),
      m_saving(std::make_unique<DocumentSaving>(
          DocumentSaving::Parts{*m_state, *m_texts, *m_loading, *m_access, *m_edits, *m_disk, *m_recovery})),
      m_model(std::make_unique<EditedModel>(*m_state, *m_loading, *m_opening)) {
    connect(m_opening.get(), &ProjectOpening::opened, this, &Document::opened);
    connect(m_opening.get(), &ProjectOpening::cancelled, m_disk.get(), &ExternalChanges::check); // postponed while opening
    connect(m_loading.get(), &DocumentLoading::changed, this, &Document::changed);
    connect(&m_state->messages, &DocumentMessages::refused, this, &Document::refused);
    connect(&m_state->messages, &DocumentMessages::notice, this, &Document::notice);
    connect(&m_state->messages, &DocumentMessages::selectionRequested, this, &Document::selectionRequested);
    connect(&m_state->journal, &JournalWriter::failed, this, [this](const QString& reason) {
        Q_EMIT notice(tr("Unsaved edits cannot be recovered after a crash: %1").arg(reason));
    });
}

Document::~Document() = default;

const std::shared_ptr<const LoadedProject>& Document::loaded() const { return m_state->loaded; }

const std::shared_ptr<const LoadedProject>& Document::lastValid() const { return m_state->lastValid; }

std::uint64_t Document::revision() const { return m_state->revision; }

std::string Document::path() const { return m_state->isNew() ? m_state->name : m_state->opened; }

bool Document::isNew() const { return m_state->isNew(); }

const OpenOptions& Document::options() const { return m_state->options; }

void Document::setOptions(const OpenOptions& options) {
    m_state->options = options;
    m_state->options.texts.clear();
    m_state->options.sets.clear();
    m_state->options.previous = nullptr;
    m_loading->readAgain();
}

} // namespace trundle
