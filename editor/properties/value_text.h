#pragma once
// Values as texts: taken apart as the language reads them, and put together as its authors write them.

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "lang/tree.h"
#include "schema/kind.h"

namespace trundle {

/// The elements of a text that is one value and nothing else; ranges count from its first byte. Fails with what is wrong.
[[nodiscard]] Result<std::vector<Element>> readElements(const std::string& text);
/// Without blanks at the ends, and with U+2212 (pasted from papers) as a minus.
[[nodiscard]] std::string tidied(std::string text);
/// Arithmetic as the language wants it, "$(0.25/2)" for "0.25/2"; everything else as it is.
/// Where only numbers stand "wheelRadius/2" is none of the words that may hold a slash.
[[nodiscard]] std::string withArithmetic(const std::string& text, bool onlyNumbers);
/// A text, file or name as an element: a word where the language takes it as one, else in quotes. `$...` and what is in quotes
/// already stay as typed.
[[nodiscard]] std::string wordOrQuoted(const std::string& text, bool quoted);
/// The same for each element of a list.
[[nodiscard]] std::string listOfWords(const std::string& text);
/// What an element of a text stands for: without its quotes.
[[nodiscard]] std::string plainText(std::string_view element);

/// The shortest text that reads back as the same number, without an exponent where people would not write one.
[[nodiscard]] std::string plainNumber(double value);
/// A number of the property in the unit of the text: "0.125".
[[nodiscard]] std::string numberOf(const Property& property, double si);
/// The elements as they would be written: "0", "0", "-9.81".
[[nodiscard]] std::vector<std::string> elementsOf(const Property& property, const PropertyValue& value);
[[nodiscard]] std::string joined(const std::vector<std::string>& elements, std::string_view separator);
/// How the author of a file writes lists: "," or ", ".
[[nodiscard]] std::string separatorOf(const Tree& tree);

/// A number as people read it: six digits, no noise.
[[nodiscard]] std::string rounded(double value);
/// "m, above 0", "ohm, from 1e-6 to 1e9"; empty where anything goes.
[[nodiscard]] std::string unitAndRange(const Property& property);
[[nodiscard]] bool isNumeric(const Property& property);
/// Three shares of red, green and blue.
[[nodiscard]] bool isColour(const Property& property);

} // namespace trundle
