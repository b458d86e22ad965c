#include "control/elf_reader.h"

#include <algorithm>

namespace trundle {
namespace {

// Offsets of the ELF64 header and its tables (System V ABI, chapter 4).
constexpr std::uint64_t kHeaderBytes = 64, kSymbolBytes = 24, kDynamicBytes = 16;
constexpr std::uint64_t kLoadSegment = 1, kDynamic = 6, kDynamicSymbols = 11, kNoBits = 8;
constexpr std::uint64_t kOldSearchPath = 15, kSearchPath = 29, kUnique = 10;
constexpr std::uint64_t kMaxBytes = 1ull << 62;

std::uint64_t endOf(std::uint64_t offset, std::uint64_t size) {
    return offset > kMaxBytes || size > kMaxBytes ? kMaxBytes : offset + size;
}

} // namespace

int ElfReader::bits() const {
    if (m_bytes.size() < 5) return 0;
    return m_bytes[4] == 1 ? 32 : m_bytes[4] == 2 ? 64 : 0;
}

std::uint64_t ElfReader::number(std::uint64_t offset, unsigned size) const {
    if (offset > m_bytes.size() || size > m_bytes.size() - offset) return 0;
    std::uint64_t value = 0;
    for (unsigned i = size; i-- > 0;) value = value << 8 | static_cast<unsigned char>(m_bytes[offset + i]);
    return value;
}

std::uint64_t ElfReader::bytesNeeded() const {
    std::uint64_t needed = kHeaderBytes;
    const std::uint64_t segments = number(32, 8), segmentBytes = number(54, 2), segmentCount = number(56, 2);
    needed = std::max(needed, endOf(segments, segmentBytes * segmentCount));
    for (std::uint64_t i = 0; i < segmentCount; ++i) {
        const std::uint64_t at = segments + i * segmentBytes;
        if (number(at, 4) == kLoadSegment) needed = std::max(needed, endOf(number(at + 8, 8), number(at + 32, 8)));
    }
    if (sectionCount() > 0) needed = std::max(needed, endOf(number(40, 8), number(58, 2) * sectionCount()));
    for (std::uint64_t i = 0; i < sectionCount(); ++i) {
        const Section s = section(i);
        if (s.type != kNoBits && s.type != 0) needed = std::max(needed, endOf(s.offset, s.size));
    }
    return needed;
}

ElfReader::Section ElfReader::section(std::uint64_t index) const {
    const std::uint64_t at = endOf(number(40, 8), index * number(58, 2));
    return {number(at + 4, 4), number(at + 24, 8), number(at + 32, 8), number(at + 40, 4)};
}

std::optional<bool> ElfReader::exports(std::string_view symbol) const {
    for (std::uint64_t i = 0; i < sectionCount(); ++i) {
        const Section s = section(i);
        if (s.type == kDynamicSymbols && s.link < sectionCount()) return definesIn(s, section(s.link), symbol);
    }
    return {};
}

bool ElfReader::definesIn(const Section& symbols, const Section& names, std::string_view symbol) const {
    if (!holds(symbols) || !holds(names)) return false;
    const std::string_view strings = m_bytes.substr(names.offset, names.size);
    for (std::uint64_t at = symbols.offset; at + kSymbolBytes <= symbols.offset + symbols.size; at += kSymbolBytes) {
        const bool defined = number(at + 6, 2) != 0;
        const std::uint64_t name = number(at, 4);
        if (!defined || name >= strings.size()) continue;
        const std::string_view rest = strings.substr(name);
        if (rest.starts_with(symbol) && rest.size() > symbol.size() && rest[symbol.size()] == '\0') return true;
    }
    return false;
}

bool ElfReader::holds(const Section& section) const { return endOf(section.offset, section.size) <= m_bytes.size(); }

std::vector<std::string> ElfReader::dynamicTexts(std::uint64_t tag) const {
    std::vector<std::string> texts;
    for (std::uint64_t i = 0; i < sectionCount(); ++i) {
        const Section s = section(i);
        if (s.type != kDynamic || s.link >= sectionCount()) continue;
        const Section names = section(s.link);
        if (!holds(s) || !holds(names)) continue;
        const std::string_view strings = m_bytes.substr(names.offset, names.size);
        for (std::uint64_t at = s.offset; at + kDynamicBytes <= s.offset + s.size && number(at, 8) != 0; at += kDynamicBytes)
            if (const std::uint64_t name = number(at + 8, 8); number(at, 8) == tag && name < strings.size())
                texts.emplace_back(strings.substr(name, strings.find('\0', name) - name));
    }
    return texts;
}

std::string ElfReader::searched() const {
    for (const std::uint64_t tag : {kSearchPath, kOldSearchPath}) // the older tag counts only if the newer one is missing
        if (std::vector<std::string> texts = dynamicTexts(tag); !texts.empty()) return std::move(texts[0]);
    return {};
}

std::vector<std::size_t> ElfReader::uniqueBindings() const {
    std::vector<std::size_t> places;
    for (std::uint64_t i = 0; i < sectionCount(); ++i) {
        const Section s = section(i);
        if (s.type != kDynamicSymbols || !holds(s)) continue;
        for (std::uint64_t at = s.offset; at + kSymbolBytes <= s.offset + s.size; at += kSymbolBytes)
            if (number(at + 4, 1) >> 4 == kUnique) places.push_back(at + 4);
    }
    return places;
}

std::string elfMachineName(std::uint64_t machine) {
    switch (machine) {
    case 3: return "x86 (32 bit)";
    case 8: return "MIPS";
    case 21: return "PowerPC 64";
    case 40: return "ARM (32 bit)";
    case 62: return "x86-64";
    case 183: return "AArch64";
    case 243: return "RISC-V";
    default: return "machine " + std::to_string(machine);
    }
}

std::uint64_t ownElfMachine() {
#if defined(__x86_64__)
    return 62;
#elif defined(__aarch64__)
    return 183;
#elif defined(__riscv)
    return 243;
#else
    return 0;
#endif
}

} // namespace trundle
