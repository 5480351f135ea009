// Checks of a scene's tree against the key table: names, types, ranges.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "schema.hpp"

namespace tlsph {
namespace {

void check_number(const Node& node, const Key& key) {
  const double x = node.number();
  if (!std::isfinite(x))
    throw InputError(node.place, fmt::format("must be a finite number, not {}", print_value(node)));
  const std::optional<Range>& range = key.allowed.range;
  if (range && !range->contains(x))
    throw InputError(node.place,
                     fmt::format("must be {}, not {}", range->requirement(), print_value(node)));
}

void check_word(const Node& node, const Key& key) {
  const std::vector<std::string>& words = key.allowed.words;
  const std::string& word = *node.text();
  if (words.empty() || std::find(words.begin(), words.end(), word) != words.end()) return;
  const std::string near = nearest(word, words);
  throw InputError(node.place,
                   fmt::format("unknown word \"{}\"{}; allowed: {}", word,
                               near.empty() ? "" : fmt::format(", did you mean \"{}\"", near),
                               fmt::join(words, ", ")));
}

bool is_number_list(const Node& node) {
  const auto* list = node.list();
  return list &&
         std::all_of(list->begin(), list->end(), [](const Node& x) { return x.is_number(); });
}

bool is_point_list(const Node& node) {
  const auto* list = node.list();
  return list && std::all_of(list->begin(), list->end(), is_number_list);
}

bool is_text_list(const Node& node) {
  const auto* list = node.list();
  return list && std::all_of(list->begin(), list->end(), [](const Node& x) { return x.text(); });
}

bool is_table_list(const Node& node) {
  const auto* list = node.list();
  return list && std::all_of(list->begin(), list->end(), [](const Node& x) { return x.table(); });
}

/// Which of the forms a key allows the value has, 0 if none.
unsigned form_of(const Node& node, unsigned allowed) {
  const auto has = [&](Form form, bool fits) { return (allowed & form) != 0 && fits; };
  if (has(flag, node.flag())) return flag;
  if (has(integer, node.integer())) return integer;
  if (has(number, node.is_number())) return number;
  if (has(text, node.text())) return text;
  if (has(table, node.table())) return table;
  if (has(numbers, is_number_list(node))) return numbers;
  if (has(points, is_point_list(node))) return points;
  if (has(texts, is_text_list(node))) return texts;
  if (has(tables, is_table_list(node))) return tables;
  return 0;
}

std::string describe_forms(unsigned forms) {
  std::vector<std::string> parts;
  const auto add = [&](Form form, const char* words) {
    if ((forms & form) != 0) parts.emplace_back(words);
  };
  add(flag, "true or false");
  add(integer, "a whole number");
  add(number, "a number");
  add(text, "a text in quotes");
  add(numbers, "a list of numbers");
  add(points, "a list of points [x, …]");
  add(texts, "a list of texts");
  add(table, "a table");
  add(tables, "a list of tables");
  std::string result = parts.front();
  for (std::size_t i = 1; i < parts.size(); ++i)
    result += (i + 1 == parts.size() ? " or " : ", ") + parts[i];
  return result;
}

/// `path` with the key of another name in place of its last part.
std::string sibling(const std::string& path, const std::string& from, const std::string& to) {
  return path.substr(0, path.size() - from.size()) + to;
}

[[noreturn]] void refuse_unknown(const Entry& entry, const std::string& group) {
  std::vector<std::string> names;
  for (const Key& key : schema())
    if (key.group == group) names.push_back(key.name);
  const std::string near = nearest(entry.name, names);
  std::string hint;
  if (!near.empty()) {
    hint = ", did you mean " + sibling(entry.value.path, entry.name, near);
  } else {
    // The right name in the wrong table is the other common slip.
    for (const Key& key : schema())
      if (key.name == entry.name && hint.empty() && find_key("", key.group))
        hint = fmt::format(", did you mean {}.{}", key.group, key.name);
  }
  throw InputError(entry.place,
                   fmt::format("unknown key{}; allowed here: {}", hint, fmt::join(names, ", ")));
}

void check_table(const Node& node, const std::string& group);

void check_value(const Node& node, const Key& key) {
  const unsigned form = form_of(node, key.forms);
  switch (form) {
    case 0:
      throw InputError(
          node.place, fmt::format("must be {}, not {}", describe_forms(key.forms), describe(node)));
    case integer:
    case number:
      return check_number(node, key);
    case text:
      return check_word(node, key);
    case numbers:
      for (const Node& item : *node.list()) check_number(item, key);
      return;
    case points:
      for (const Node& point : *node.list())
        for (const Node& item : *point.list()) check_number(item, key);
      return;
    case texts:
      for (const Node& item : *node.list()) check_word(item, key);
      return;
    case table:
      return check_table(node, key.below);
    case tables:
      for (const Node& item : *node.list()) check_table(item, key.below);
      return;
    default:
      return;
  }
}

/// Names first, for the whole table: a misspelt name explains what would follow from it.
void check_table(const Node& node, const std::string& group) {
  for (const Entry& entry : *node.table())
    if (!find_key(group, entry.name)) refuse_unknown(entry, group);
  for (const Entry& entry : *node.table()) check_value(entry.value, *find_key(group, entry.name));
}

/// Edit distance of two words, a swap of neighbours counted as one (Damerau, optimal alignment).
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      d[i][j] = std::min(
          {d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

}  // namespace

std::string Allowed::text() const {
  std::vector<std::string> alternatives = words;
  if (range) alternatives.push_back(range->text());
  return fmt::format("{}", fmt::join(alternatives, " | "));
}

std::string nearest(std::string_view word, const std::vector<std::string>& words) {
  constexpr std::size_t longest = 64;  // of a slip; the table of distances is as long as the word
  std::string best;
  if (word.size() > longest) return best;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const auto& candidate : words) {
    const std::size_t steps = distance(word, candidate);
    // Beyond a third of its letters a word is another word, not a slip.
    if (steps < least &&
        steps <= std::max<std::size_t>(1, std::max(word.size(), candidate.size()) / 3)) {
      least = steps;
      best = candidate;
    }
  }
  return best;
}

std::string describe(const Node& node) {
  if (node.flag() || node.is_number()) return print_value(node);
  if (const auto* word = node.text())
    return word->size() > 60 ? "a long text" : fmt::format("the text \"{}\"", *word);
  if (node.table()) return "a table";
  if (const auto* list = node.list()) {
    const std::string printed = print_value(node);
    return printed.size() > 60 ? fmt::format("a list of {} values", list->size())
                               : "the list " + printed;
  }
  return "a date or time";
}

void check_document(const Node& root) {
  check_table(root, "");
}

}  // namespace tlsph
