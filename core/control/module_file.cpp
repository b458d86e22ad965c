#include "control/module_file.h"

#include <bit>

#include <trundle/abi.h>

#include "base/platform/read_file.h"
#include "control/elf_reader.h"

namespace trundle {
namespace {

constexpr std::uint64_t kMaxModuleBytes = 1ull << 30;

Error wrongFormat(const std::string& path, const std::string& why) { return {Code::ModuleWrongFormat, path + " " + why}; }

std::string notElf(const std::string& bytes) {
    if (bytes.empty()) return "is empty; a module is a shared library";
    std::string start;
    for (const char c : bytes.substr(0, 20)) {
        if (c < ' ' || c > '~') break;
        start += c;
    }
    if (start.size() < 3) return "is no shared library";
    return "is no shared library; it starts with \"" + start + "\"";
}

/// Checks that the file was built for this program's machine.
Status checkMachine(const std::string& path, const ElfReader& elf) {
    if (elf.bits() == 32) return wrongFormat(path, "is a 32-bit library; this program is 64-bit");
    if (elf.bits() != 64) return wrongFormat(path, "is neither a 32-bit nor a 64-bit library");
    if (elf.bigEndian() != (std::endian::native == std::endian::big))
        return wrongFormat(path, "has the byte order of another machine");
    if (elf.machine() != ownElfMachine() && ownElfMachine() != 0)
        return wrongFormat(path, "is built for " + elfMachineName(elf.machine()) + "; this program is built for " +
                                     elfMachineName(ownElfMachine()));
    return {};
}

Status check(const std::string& path, const std::string& bytes) {
    const ElfReader elf(bytes);
    if (!elf.isElf()) return wrongFormat(path, notElf(bytes));
    if (bytes.size() < 20)
        return Error{Code::ModuleUnreadable, path + " is cut off: it has only " + std::to_string(bytes.size()) + " bytes"};
    if (auto status = checkMachine(path, elf); !status) return status;
    if (elf.type() == 1) return wrongFormat(path, "is an object file; a module is a linked shared library");
    if (elf.type() == 2) return wrongFormat(path, "is a program; a module is a shared library");
    if (elf.type() != 3) return wrongFormat(path, "is no shared library");
    if (elf.bytesNeeded() > bytes.size())
        return Error{Code::ModuleUnreadable, path + " is cut off: it has " + std::to_string(bytes.size()) +
                                                 " bytes and its tables need " + std::to_string(elf.bytesNeeded())};
    if (!elf.exports(TRUNDLE_ENTRY_SYMBOL).value_or(true))
        return Error{Code::ModuleNoEntry,
                     path + " exports no " TRUNDLE_ENTRY_SYMBOL "; a module's source ends with TRUNDLE_MODULE(registry) { ... }"};
    return {};
}

} // namespace

Result<std::string> readModuleFile(const std::string& path) {
    const auto before = regularFileStamp(path);
    auto file = readRegularFile(path, kMaxModuleBytes);
    if (!file) return Error{Code::ModuleUnreadable, file.error().message};
    const auto after = regularFileStamp(path);
    if (!before || !after || !(before.value() == after.value()))
        return Error{Code::ModuleUnreadable, path + " is being written; try again when that is done"};
    if (auto status = check(path, file.value()); !status) return status.error();
    return file;
}

Status checkModuleFile(const std::string& path) {
    if (auto file = readModuleFile(path); !file) return file.error();
    return {};
}

} // namespace trundle
