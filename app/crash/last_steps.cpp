#include "crash/last_steps.h"

#include <cerrno>

#include <sys/mman.h>
#include <unistd.h>

#include "base/platform/buffered_file.h"

namespace trundle {

void LastSteps::take() {
    const Step failed = m_begun; // this is called in a fault of that step
    if (failed == None) {
        m_begun = Reporting;
        report();
    } else if (failed == Reporting) {
        m_begun = WithoutHeap;
        reportWithoutHeap();
    }
    if (failed < Logs) {
        m_begun = Logs;
        BufferedFile::writeOutAll();
    } else if (failed == Logs) {
        m_begun = LostLogs;
        reportLostLogs();
    }
    m_begun = Done;
}

Draft::Draft(int file) : m_file(file), m_draft(memfd_create("trundle-report", MFD_CLOEXEC)) {}

Draft::~Draft() {
    if (m_draft >= 0) close(m_draft);
}

void Draft::publish() {
    if (m_draft < 0 || m_file < 0 || lseek(m_draft, 0, SEEK_SET) != 0) return;
    char bytes[1024];
    for (ssize_t got; (got = read(m_draft, bytes, sizeof bytes)) > 0;)
        for (ssize_t done = 0; done < got;) {
            const ssize_t part = write(m_file, bytes + done, static_cast<std::size_t>(got - done));
            if (part < 0 && errno == EINTR) continue;
            if (part <= 0) return;
            done += part;
        }
}

} // namespace trundle
