#pragma once
// Grey pictures of 16 bits a point in the PGM format (netpbm's description of it, "PGM Format Specification"), of which Qt keeps 8 bits.

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace trundle {

struct DeepPgm {
    std::uint32_t columns = 0, rows = 0;
    std::uint32_t most = 0;  ///< the value of white, 256 to 65535
    bool isText = false;     ///< P2; else P5: two bytes a point, the greater one first
    std::string_view points; ///< what follows the header

    /// 0 to 1, row by row from the top. None: there are fewer points, or one is above `most`.
    [[nodiscard]] std::optional<std::vector<float>> heights() const;
};

/// None: it is no such picture.
[[nodiscard]] std::optional<DeepPgm> deepPgmIn(std::string_view content);

} // namespace trundle
