#include "scree/config/quantity.hpp"

#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "scree/config/unit.hpp"

namespace scree {
namespace {

constexpr int max_nesting = 32;

/// A number with a unit; without one it is a factor, or a value in the unit wanted.
struct Value {
  double number;
  Unit unit;
};

bool starts_unit(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '%' || (c & 0x80); }

/// Recursive descent over
///   sum = product {(+|-) product};  product = factor {(*|/| ) factor};  factor = [+|-] (number [unit] | ${name} |
///   (sum))
class Expression {
 public:
  Expression(const std::string& text, const Unit& wanted, const Definitions& definitions, int nesting)
      : text_(text), wanted_(wanted), definitions_(definitions), nesting_(nesting) {
    if (nesting > max_nesting) throw QuantityError("definitions refer to each other, or parentheses are too deep");
  }

  Value whole() {
    Value value = sum();
    if (peek() != '\0') throw QuantityError("cannot read '" + text_.substr(at_) + "'");
    return value;
  }

 private:
  Value sum() {
    Value left = product();
    while (peek() == '+' || peek() == '-') {
      const double sign = next() == '+' ? 1 : -1;
      const Value right = product();
      if (!left.unit && !right.unit)
        left.number += sign * right.number;
      else
        left = {in_wanted(left) + sign * in_wanted(right), wanted_};
    }
    return left;
  }

  Value product() {
    Value left = factor();
    for (;;) {
      const char c = peek();
      if (c == '*') next();
      if (c == '/') next();
      if (c == '/')
        left = divided(left, starts_unit(peek()) ? Value{1.0, unit()} : factor());
      else if (c == '*' || c == '$')
        left = multiplied(left, factor());
      else
        return left;
    }
  }

  Value factor() {
    const char c = peek();
    if (c == '+' || c == '-') {
      next();
      const Value value = factor();
      return {c == '-' ? -value.number : value.number, value.unit};
    }
    if (c == '(') return parenthesis();
    if (c == '$') return reference();
    return number();
  }

  Value parenthesis() {
    if (++nesting_ > max_nesting) throw QuantityError("parentheses are too deep");
    next();
    Value value = sum();
    if (next() != ')') throw QuantityError("')' is missing");
    --nesting_;
    return value;
  }

  Value reference() {
    const auto end = text_.find('}', at_);
    if (text_.compare(at_, 2, "${") != 0 || end == std::string::npos) throw QuantityError("'${name}' is malformed");
    const std::string name = text_.substr(at_ + 2, end - at_ - 2);
    at_ = end + 1;
    const std::string* definition = definitions_ ? definitions_(name) : nullptr;
    if (!definition) throw QuantityError("'" + name + "' is not defined under 'define'");
    return Expression(*definition, wanted_, definitions_, nesting_ + 1).whole();
  }

  Value number() {
    const char c = peek();
    const char* begin = text_.c_str() + at_;
    const bool hexadecimal = c == '0' && (begin[1] == 'x' || begin[1] == 'X');
    if (hexadecimal || !(std::isdigit(static_cast<unsigned char>(c)) || c == '.'))
      throw QuantityError(c ? "cannot read '" + std::string(begin) + "' as a number" : "a number is missing");
    char* end = nullptr;
    const double value = std::strtod(begin, &end);
    if (end == begin) throw QuantityError("cannot read '" + std::string(begin) + "' as a number");
    at_ += static_cast<std::size_t>(end - begin);
    return {value, starts_unit(peek()) ? unit() : Unit()};
  }

  /// The longest unit from here: words with exponents, joined by blanks, '*', '.' or '/', or '/(' words ')'.
  Unit unit() {
    const std::size_t begin = at_;
    for (;;) {
      if (text_[at_] == '(') {
        const auto close = text_.find(')', at_);
        at_ = close == std::string::npos ? text_.size() : close + 1;
      } else {
        skip_unit_word();
      }
      std::size_t ahead = text_.find_first_not_of(" \t", at_);
      if (ahead == std::string::npos) break;
      const bool joined = text_[ahead] == '*' || text_[ahead] == '/' || text_[ahead] == '.';
      if (joined) ahead = text_.find_first_not_of(" \t", ahead + 1);
      if (ahead == std::string::npos) break;
      const bool opens = joined && text_[ahead] == '(' && ahead + 1 < text_.size() && starts_unit(text_[ahead + 1]);
      if (!opens && !starts_unit(text_[ahead])) break;
      at_ = ahead;
    }
    return parse_unit(text_.substr(begin, at_ - begin));
  }

  void skip_unit_word() {
    const auto digit = [this](std::size_t i) { return i < text_.size() && std::isdigit(text_[i] & 0x7f); };
    while (at_ < text_.size() && (starts_unit(text_[at_]) || text_[at_] == '_')) ++at_;
    std::size_t exponent = at_;
    if (exponent < text_.size() && text_[exponent] == '^') ++exponent;
    if (exponent < text_.size() && text_[exponent] == '-') ++exponent;
    if (!digit(exponent)) return;
    for (at_ = exponent; digit(at_);) ++at_;
  }

  double in_wanted(const Value& value) const {
    return value.unit ? converted(value.number, value.unit, wanted_) : value.number;
  }

  static Value multiplied(const Value& a, const Value& b) {
    return {a.number * b.number, !a.unit ? b.unit : !b.unit ? a.unit : unit_product(a.unit, b.unit)};
  }

  static Value divided(const Value& a, const Value& b) {
    if (!b.unit) return {a.number / b.number, a.unit};
    return {a.number / b.number, unit_quotient(a.unit ? a.unit : parse_unit("1"), b.unit)};
  }

  char peek() {
    at_ = std::min(text_.find_first_not_of(" \t", at_), text_.size());
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  char next() {
    const char c = peek();
    if (c) ++at_;
    return c;
  }

  const std::string text_;
  const Unit wanted_;
  const Definitions& definitions_;
  int nesting_;
  std::size_t at_ = 0;
};

}  // namespace

double quantity(const std::string& text, const std::string& unit, const Definitions& definitions) {
  const Unit wanted = parse_unit(unit);
  const Value value = Expression(text, wanted, definitions, 0).whole();
  const double number = value.unit ? converted(value.number, value.unit, wanted) : value.number;
  if (!std::isfinite(number)) throw QuantityError("the value is not finite");
  return number;
}

std::string with_definitions(std::string text, const Definitions& definitions) {
  for (int replaced = 0;; ++replaced) {
    const auto begin = text.find("${");
    if (begin == std::string::npos) return text;
    const auto end = text.find('}', begin);
    if (end == std::string::npos || replaced > max_nesting) throw QuantityError("'${name}' is malformed or circular");
    const std::string name = text.substr(begin + 2, end - begin - 2);
    const std::string* definition = definitions ? definitions(name) : nullptr;
    if (!definition) throw QuantityError("'" + name + "' is not defined under 'define'");
    text.replace(begin, end - begin + 1, *definition);
  }
}

std::vector<std::string> split_list(const std::string& text) {
  std::vector<std::string> items;
  if (text.find_first_not_of(" \t") == std::string::npos) return items;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t comma = std::min(text.find(',', begin), text.size());
    const std::size_t first = std::min(text.find_first_not_of(" \t", begin), comma);
    const std::size_t last = text.find_last_not_of(" \t", comma == 0 ? 0 : comma - 1);
    items.push_back(first < comma ? text.substr(first, last - first + 1) : "");
    begin = comma + 1;
  }
  return items;
}

std::string number_text(double value, int digits) {
  char text[64];
  const std::to_chars_result end =
      digits ? std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits)
             : std::to_chars(text, text + sizeof text, value);
  return {text, end.ptr};
}

}  // namespace scree
