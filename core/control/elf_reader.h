#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trundle {

/// Reads the header of an ELF file and its table of exported symbols. Every offset is checked against the end of the bytes.
class ElfReader {
public:
    explicit ElfReader(std::string_view bytes) : m_bytes(bytes) {}

    [[nodiscard]] bool isElf() const {
        return m_bytes.starts_with("\x7f"
                                   "ELF");
    }
    [[nodiscard]] int bits() const; ///< 32, 64, or 0 if not specified
    [[nodiscard]] bool bigEndian() const { return m_bytes.size() > 5 && m_bytes[5] == 2; }
    [[nodiscard]] std::uint64_t type() const { return number(16, 2); }    ///< 1 object, 2 program, 3 shared object
    [[nodiscard]] std::uint64_t machine() const { return number(18, 2); } ///< 62 x86-64, 183 aarch64

    // For 64-bit little-endian files:
    /// The minimum file size required by its tables.
    [[nodiscard]] std::uint64_t bytesNeeded() const;
    /// Whether it defines an exported symbol; empty if the file has no usable symbol table.
    [[nodiscard]] std::optional<bool> exports(std::string_view symbol) const;
    /// The names of the required libraries, in order.
    [[nodiscard]] std::vector<std::string> needs() const { return dynamicTexts(1); }
    /// The library search path (RUNPATH or RPATH), separated by colons; empty: none.
    [[nodiscard]] std::string searched() const;
    /// File offsets of the binding bytes of exported symbols with process-wide binding (STB_GNU_UNIQUE).
    [[nodiscard]] std::vector<std::size_t> uniqueBindings() const;

private:
    /// 0 beyond the end of the bytes.
    [[nodiscard]] std::uint64_t number(std::uint64_t offset, unsigned size) const;
    struct Section {
        std::uint64_t type, offset, size, link;
    };
    [[nodiscard]] std::uint64_t sectionCount() const { return number(40, 8) ? number(60, 2) : 0; }
    [[nodiscard]] Section section(std::uint64_t index) const;
    [[nodiscard]] bool holds(const Section& section) const;
    [[nodiscard]] bool definesIn(const Section& symbols, const Section& names, std::string_view symbol) const;
    [[nodiscard]] std::vector<std::string> dynamicTexts(std::uint64_t tag) const;

    std::string_view m_bytes;
};

/// "x86-64" for 62; the number itself if its name is unknown.
[[nodiscard]] std::string elfMachineName(std::uint64_t machine);
/// The ELF machine that this program was built for; 0 if unknown.
[[nodiscard]] std::uint64_t ownElfMachine();

} // namespace trundle
