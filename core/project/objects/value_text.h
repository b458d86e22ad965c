#pragma once
// Conversion between values and texts: parsing into elements, and formatting as in hand-written files.

#include <string>
#include <string_view>
#include <vector>

#include "lang/parsed_value.h"
#include "lang/tree.h"
#include "schema/kind.h"

namespace trundle {

/// Without leading and trailing blanks, and with U+2212 (pasted from papers) replaced by a minus.
[[nodiscard]] std::string tidied(std::string text);
/// Encloses arithmetic as the language requires, "$(0.25/2)" for "0.25/2"; other texts are unchanged.
/// With onlyNumbers, "wheelRadius/2" is arithmetic too; otherwise it may be a path.
[[nodiscard]] ParsedValue withArithmetic(const std::string& text, bool onlyNumbers);
/// A text, file or name as an element: unquoted if the language allows it, else in quotes. `$...` and quoted texts are
/// unchanged.
[[nodiscard]] ParsedValue wordOrQuoted(const std::string& text, bool quoted);
/// The same for each element of a list.
[[nodiscard]] ParsedValue listOfWords(const std::string& text);
/// The text of an element without its quotes.
[[nodiscard]] std::string plainText(std::string_view element);

/// The shortest text that parses to the same number, without an exponent for common magnitudes.
[[nodiscard]] std::string plainNumber(double value);
/// A number of the property in the property's unit: "0.125".
[[nodiscard]] std::string numberOf(const Property& property, double si);
/// The elements in written form: "0", "0", "-9.81".
[[nodiscard]] std::vector<std::string> elementsOf(const Property& property, const PropertyValue& value);
[[nodiscard]] std::string joined(const std::vector<std::string>& elements, std::string_view separator);
/// The list separator that the file uses: "," or ", ".
[[nodiscard]] std::string separatorOf(const Tree& tree);

/// A number for display, rounded to six significant digits.
[[nodiscard]] std::string rounded(double value);
/// "m, above 0", "ohm, from 1e-6 to 1e9"; empty if there is neither.
[[nodiscard]] std::string unitAndRange(const Property& property);
[[nodiscard]] bool isNumeric(const Property& property);
/// Whether the property is a colour: red, green and blue.
[[nodiscard]] bool isColour(const Property& property);

} // namespace trundle
