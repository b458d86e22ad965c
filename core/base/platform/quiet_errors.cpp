#include "base/platform/quiet_errors.h"

#include <fcntl.h>
#include <unistd.h>

namespace trundle {

QuietErrors::QuietErrors() : m_errors(::dup(STDERR_FILENO)) {
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (m_errors >= 0 && nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
    if (nowhere >= 0) ::close(nowhere);
}

QuietErrors::~QuietErrors() {
    if (m_errors < 0) return;
    ::dup2(m_errors, STDERR_FILENO);
    ::close(m_errors);
}

} // namespace trundle
