#include "crash/uncaught_exception.h"

#include <cstdlib>
#include <cstring>
#include <exception>

#include "crash/signal_text.h"

namespace trundle {
namespace {

const char* s_name = "";
int (*s_messages)() = nullptr;
char s_text[512] = "";

void onTerminate() {
    const auto addText = [](const char* what) {
        std::strncpy(s_text, what, sizeof s_text - 1);
        SignalText(s_messages()).addClean(s_name).add(": an uncaught exception: ").addClean(what).add("\n");
    };
    try {
        if (std::current_exception()) throw;
    } catch (const std::exception& e) { addText(e.what()); } catch (...) {
        addText("of an unknown type");
    }
    std::abort();
}

} // namespace

void reportUncaughtExceptions(const char* program, int (*file)()) {
    s_name = program;
    s_messages = file;
    std::set_terminate(&onTerminate);
}

const char* uncaughtException() noexcept { return s_text; }

} // namespace trundle
