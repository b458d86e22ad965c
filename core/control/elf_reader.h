#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trundle {

/// What the first bytes of an ELF file say, and its table of exported symbols. Reads bytes, follows no offset out of them.
class ElfReader {
public:
    explicit ElfReader(std::string_view bytes) : m_bytes(bytes) {}

    [[nodiscard]] bool isElf() const {
        return m_bytes.starts_with("\x7f"
                                   "ELF");
    }
    [[nodiscard]] int bits() const; ///< 32, 64, or 0 where the file does not say
    [[nodiscard]] bool bigEndian() const { return m_bytes.size() > 5 && m_bytes[5] == 2; }
    [[nodiscard]] std::uint64_t type() const { return number(16, 2); }    ///< 1 object, 2 program, 3 shared object
    [[nodiscard]] std::uint64_t machine() const { return number(18, 2); } ///< 62 x86-64, 183 aarch64

    // For 64-bit little-endian files:
    /// How many bytes its tables need the file to have.
    [[nodiscard]] std::uint64_t bytesNeeded() const;
    /// Whether it defines an exported symbol; nothing where the file has no table that tells.
    [[nodiscard]] std::optional<bool> exports(std::string_view symbol) const;
    /// The names of the libraries that it needs, in order.
    [[nodiscard]] std::vector<std::string> needs() const { return dynamicTexts(1); }
    /// The folders, joined by colons, in which its loader looks for them; empty: none of its own.
    [[nodiscard]] std::string searched() const;
    /// Places in the file where the binding of an exported symbol is one for the whole process (STB_GNU_UNIQUE).
    [[nodiscard]] std::vector<std::size_t> uniqueBindings() const;

private:
    /// 0 where the bytes end before.
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

/// "x86-64" for 62; the number where the name is not known.
[[nodiscard]] std::string elfMachineName(std::uint64_t machine);
/// Of the machine this program was built for; 0 where that is no ELF machine known here.
[[nodiscard]] std::uint64_t ownElfMachine();

} // namespace trundle
