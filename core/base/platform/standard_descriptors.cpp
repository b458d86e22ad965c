#include "base/platform/standard_descriptors.h"

#include <fcntl.h>
#include <unistd.h>

namespace trundle {

bool openIfClosed(int descriptor) {
    if (::fcntl(descriptor, F_GETFD) >= 0) return true;
    const int nowhere = ::open("/dev/null", descriptor == STDIN_FILENO ? O_RDONLY : O_WRONLY);
    if (nowhere >= 0 && nowhere != descriptor) {
        ::dup2(nowhere, descriptor);
        ::close(nowhere);
    }
    return false;
}

bool openStandardDescriptors() {
    (void)openIfClosed(STDIN_FILENO);
    const bool hasOutput = openIfClosed(STDOUT_FILENO);
    (void)openIfClosed(STDERR_FILENO);
    return hasOutput;
}

} // namespace trundle
