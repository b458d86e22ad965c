#include "editor/document/journal_writer.h"

#include <QCoreApplication>

namespace trundle {

namespace {
constexpr int kDelayMs = 500;
}

JournalWriter::JournalWriter(const OpenFiles& files, QObject* parent) : QObject(parent), m_files(files) {
    m_timer.setSingleShot(true);
    m_timer.setInterval(kDelayMs);
    m_syncing.setMaxThreadCount(1);
    connect(&m_timer, &QTimer::timeout, this, &JournalWriter::writeNow);
    // When the session manager or a signal ends the program, it asks no question about unsaved texts, so the journal must be
    // complete.
    if (QCoreApplication* program = QCoreApplication::instance())
        connect(program, &QCoreApplication::aboutToQuit, this, &JournalWriter::writeNow);
}

JournalWriter::~JournalWriter() { stop(); }

void JournalWriter::start(const std::string& projectFolder, JournalHead head) {
    stop();
    m_journal = std::make_unique<Journal>(projectFolder, std::move(head));
}

void JournalWriter::stop() {
    m_timer.stop();
    if (m_journal) m_journal->discard();
    m_journal.reset();
    m_reportedFailure = false;
}

// A running timer is not restarted by later edits, so continuous typing is written too.
void JournalWriter::later() {
    if (m_journal && !m_timer.isActive()) m_timer.start();
}

void JournalWriter::writeNow() {
    m_timer.stop();
    if (!m_journal) return;
    const Status written = write();
    if (!written && !m_reportedFailure) Q_EMIT failed(QString::fromStdString(written.error().message));
    m_reportedFailure = !written;
}

std::string JournalWriter::path() const {
    const auto file = m_journal ? m_journal->file() : nullptr;
    return file ? file->path() : std::string();
}

Status JournalWriter::write() {
    Status first;
    for (const std::string& path : m_files.inWritingOrder()) {
        const OpenFile& file = *m_files.find(path);
        const Status done = file.edited() ? m_journal->note(path, file.disk, file.text, file.made) : m_journal->forget(path);
        if (!done && first) first = done;
    }
    // One pending sync is enough: the next write starts another.
    if (const auto file = m_journal->file(); file && m_syncing.activeThreadCount() == 0)
        m_syncing.start([file] { (void)file->sync(); });
    return first;
}

} // namespace trundle
