#include "editor/document/journal_keeper.h"

#include <QCoreApplication>

namespace trundle {

namespace {
constexpr int kDelayMs = 500;
}

JournalKeeper::JournalKeeper(const OpenFiles& files, QObject* parent) : QObject(parent), m_files(files) {
    m_timer.setSingleShot(true);
    m_timer.setInterval(kDelayMs);
    m_syncing.setMaxThreadCount(1);
    connect(&m_timer, &QTimer::timeout, this, &JournalKeeper::writeNow);
    // Whoever is told to end from outside asks nobody about unsaved texts; who was asked has closed them.
    if (QCoreApplication* program = QCoreApplication::instance())
        connect(program, &QCoreApplication::aboutToQuit, this, &JournalKeeper::writeNow);
}

JournalKeeper::~JournalKeeper() { stop(); }

void JournalKeeper::start(const std::string& projectFolder, JournalHead head) {
    stop();
    m_journal = std::make_unique<Journal>(projectFolder, std::move(head));
}

void JournalKeeper::stop() {
    m_timer.stop();
    if (m_journal) m_journal->discard();
    m_journal.reset();
    m_saidFailed = false;
}

// Not started anew by each edit: who types without a pause is noted all the same.
void JournalKeeper::later() {
    if (m_journal && !m_timer.isActive()) m_timer.start();
}

void JournalKeeper::writeNow() {
    m_timer.stop();
    if (!m_journal) return;
    const Status written = write();
    if (!written && !m_saidFailed) Q_EMIT failed(QString::fromStdString(written.error().message));
    m_saidFailed = !written;
}

std::string JournalKeeper::path() const {
    const auto file = m_journal ? m_journal->file() : nullptr;
    return file ? file->path() : std::string();
}

Status JournalKeeper::write() {
    Status first;
    for (const std::string& path : m_files.inWritingOrder()) {
        const OpenFile& file = *m_files.find(path);
        const Status done = file.edited() ? m_journal->note(path, *file.disk, *file.text, file.made) : m_journal->forget(path);
        if (!done && first) first = done;
    }
    // One wait that is under way is enough: the next write comes with its own.
    if (const auto file = m_journal->file(); file && m_syncing.activeThreadCount() == 0)
        m_syncing.start([file] { (void)file->sync(); });
    return first;
}

} // namespace trundle
