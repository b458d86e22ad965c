#include "editor/document/document_texts.h"

#include <algorithm>

#include "editor/document/document_state.h"

namespace trundle {

std::string DocumentTexts::shown(const std::string& file) const { return m_state.shown(file); }

bool DocumentTexts::isSample(const std::string& file) const { return m_state.isSample(file); }

std::vector<std::string> DocumentTexts::files() const {
    std::vector<std::string> files;
    if (!m_state.isOpen()) return files;
    for (const std::string& path : m_state.loaded->paths)
        if (!path.empty()) files.push_back(path);
    return files;
}

SharedText DocumentTexts::text(const std::string& file) const {
    return m_state.files.text(m_state.isNew() && file == m_state.name ? m_state.opened : file);
}

bool DocumentTexts::isModified() const { return !m_state.files.modified().empty(); }

bool DocumentTexts::isModified(const std::string& file) const {
    const OpenFile* known = m_state.files.find(file);
    return known && known->modified();
}

bool DocumentTexts::isRemoved(const std::string& file) const {
    const OpenFile* open = m_state.isOpen() ? m_state.files.find(file) : nullptr;
    return open && open->isRemoved();
}

std::vector<std::string> DocumentTexts::modifiedFiles() const {
    std::vector<std::string> files = m_state.files.modified();
    const auto opened = std::ranges::find(files, m_state.opened);
    if (opened != files.end()) std::rotate(files.begin(), opened, opened + 1);
    return files;
}

std::vector<std::string> DocumentTexts::modifiedSamples() const {
    std::vector<std::string> samples = m_state.files.modified();
    std::erase_if(samples, [&](const std::string& file) { return !isSample(file); });
    return samples;
}

void DocumentTexts::checkModified() {
    m_state.journal.later();
    const std::vector<std::string> modified = m_state.files.modified();
    std::set<std::string> now(modified.begin(), modified.end());
    if (now == m_reported) return;
    m_reported = std::move(now);
    Q_EMIT modifiedChanged();
}

} // namespace trundle
