// Checks of a scene's tree against the key table: names, types, ranges; views of what is checked.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "schema.hpp"

namespace tlsph {
namespace {

void check_number(const Node& node, const Key& key) {
  const double x = node.number();
  if (!std::isfinite(x)) fail_at(node.place, "must be a finite number, not {}", print_value(node));
  const std::optional<Range>& range = key.allowed.range;
  if (range && !range->contains(x))
    fail_at(node.place, "must be {}, not {}", range->requirement(), print_value(node));
}

void check_word(const Node& node, const Key& key) {
  const std::vector<std::string>& words = key.allowed.words;
  const std::string& word = *node.text();
  if (words.empty() || std::find(words.begin(), words.end(), word) != words.end()) return;
  const std::string near = nearest(word, words);
  fail_at(node.place, "unknown word \"{}\"{}; allowed: {}", word,
          near.empty() ? "" : fmt::format(", did you mean \"{}\"", near), fmt::join(words, ", "));
}

/// The form of the items of a list of that form; empty if it is no list.
std::optional<Form> items_of(Form form) {
  switch (form) {
    case numbers:
      return number;
    case points:
      return numbers;
    case texts:
      return text;
    case tables:
      return table;
    default:
      return std::nullopt;
  }
}

bool fits(const Node& node, Form form) {
  if (const auto item_form = items_of(form))
    return node.list() && std::ranges::all_of(*node.list(), [&](const Node& item) {
             return fits(item, *item_form);
           });
  return (form == flag && node.flag()) || (form == integer && node.integer()) ||
         (form == number && node.is_number()) || (form == text && node.text()) ||
         (form == table && node.table());
}

std::string describe_forms(unsigned forms) {
  std::string result, last;
  for (const FormWords& words : form_words) {
    if ((forms & words.form) == 0) continue;
    if (!last.empty()) result += (result.empty() ? "" : ", ") + last;
    last = words.in_messages;
  }
  return result.empty() ? last : result + " or " + last;
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
  fail_at(entry.place, "unknown key{}; allowed here: {}", hint, fmt::join(names, ", "));
}

void check_table(const Node& node, const std::string& group);

void check_form(const Node& node, const Key& key, Form form) {
  if (const auto item_form = items_of(form))
    for (const Node& item : *node.list()) check_form(item, key, *item_form);
  else if (form == integer || form == number)
    check_number(node, key);
  else if (form == text)
    check_word(node, key);
  else if (form == table)
    check_table(node, key.below);
}

void check_value(const Node& node, const Key& key) {
  const auto* found = std::ranges::find_if(form_words, [&](const FormWords& words) {
    return (key.forms & words.form) != 0 && fits(node, words.form);
  });
  if (found == std::end(form_words))
    fail_at(node.place, "must be {}, not {}", describe_forms(key.forms), describe(node));
  check_form(node, key, found->form);
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

const Key& TableView::key(std::string_view name) const {
  const Key* found = find_key(group_, name);
  assert(found && "the reader asks only for keys of the key table");
  return *found;
}

const Node* TableView::find(std::string_view name) const {
  static_cast<void>(key(name));
  return node_ ? node_->find(name) : nullptr;
}

Place TableView::place_of(std::string_view name) const {
  if (const Node* value = find(name)) return value->place;
  Place place = place_;
  place.key = join_path(path_, std::string(name));
  return place;
}

TableView TableView::table(std::string_view name) const {
  if (const Node* value = find(name)) return {*value, key(name).below};
  return {key(name).below, join_path(path_, std::string(name)), place_of(name)};
}

std::vector<TableView> TableView::tables(std::string_view name) const {
  std::vector<TableView> views;
  if (const Node* value = find(name))
    for (const Node& item : *value->list()) views.emplace_back(item, key(name).below);
  return views;
}

const Node& TableView::require(std::string_view name) const {
  if (const Node* value = find(name)) return *value;
  const Key& missing = key(name);
  std::string what = missing.doc;
  if (!missing.unit.empty()) what += (what.empty() ? "in " : ", in ") + missing.unit;
  fail_at(place_of(name), "missing{}{}", what.empty() ? "" : ": ", what);
}

std::vector<double> read_vector(const Node& node, int length, const std::string& meaning) {
  const auto& list = *node.list();
  if (static_cast<int>(list.size()) != length)
    fail_at(node.place, "must have {} number{}, {}, not {}", length, length == 1 ? "" : "s",
            meaning, list.size());
  std::vector<double> result;
  for (const Node& item : list) result.push_back(item.number());
  return result;
}

}  // namespace tlsph
