#include "tlsph/io/json.hpp"

#include <cassert>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "tlsph/core/error.hpp"
#include "tlsph/io/files.hpp"

namespace tlsph {

using Node = nlohmann::ordered_json;

struct Json::Tree {
  Node root = Node::object();

  Node& make(std::string_view path) {
    Node* node = &root;
    for (std::size_t begin = 0; begin <= path.size();) {
      const std::size_t end = std::min(path.find('.', begin), path.size());
      assert(node->is_object() || node->is_null());
      node = &(*node)[std::string(path.substr(begin, end - begin))];
      begin = end + 1;
    }
    return *node;
  }

  [[nodiscard]] const Node* find(std::string_view path) const {
    const Node* node = &root;
    for (std::size_t begin = 0; begin <= path.size();) {
      const std::size_t end = std::min(path.find('.', begin), path.size());
      if (!node->is_object()) return nullptr;
      const auto child = node->find(std::string(path.substr(begin, end - begin)));
      if (child == node->end()) return nullptr;
      node = &*child;
      begin = end + 1;
    }
    return node;
  }

  template <class T>
  [[nodiscard]] T get(std::string_view path, bool (*fits)(const Node&), const char* type) const {
    const Node* node = find(path);
    if (node == nullptr) throw InputError(std::string(path) + ": missing");
    if (!fits(*node)) throw InputError(std::string(path) + ": must be " + type);
    return node->get<T>();
  }
};

Json::Json() : tree_(std::make_unique<Tree>()) {}
Json::Json(const Json& other) : tree_(std::make_unique<Tree>(*other.tree_)) {}
Json::Json(Json&&) noexcept = default;
Json& Json::operator=(const Json& other) {
  if (this != &other) tree_ = std::make_unique<Tree>(*other.tree_);
  return *this;
}
Json& Json::operator=(Json&&) noexcept = default;
Json::~Json() = default;

Json Json::parse(std::string_view text, const std::string& origin) {
  Json json;
  try {
    json.tree_->root = Node::parse(text);
  } catch (const Node::parse_error& error) {
    throw InputError(origin + ": " + error.what());
  }
  return json;
}

Json Json::read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw InputError(path.string() + ": cannot be read");
  return parse(text, path.string());
}

void Json::set(std::string_view path, double value) {
  tree_->make(path) = value;
}
void Json::set(std::string_view path, std::string_view value) {
  tree_->make(path) = std::string(value);
}
void Json::set(std::string_view path, std::nullptr_t) {
  tree_->make(path) = nullptr;
}
void Json::set(std::string_view path, const std::optional<double>& value) {
  if (value)
    set(path, *value);
  else
    set(path, nullptr);
}
void Json::set_or_null(std::string_view path, std::string_view text) {
  if (text.empty())
    set(path, nullptr);
  else
    set(path, text);
}
void Json::set(std::string_view path, const std::vector<double>& values) {
  tree_->make(path) = values;
}
void Json::set(std::string_view path, const std::vector<std::string>& values) {
  tree_->make(path) = values;
}
void Json::set(std::string_view path, const Json& tree) {
  Node copy = tree.tree_->root;  // `tree` may be this document
  tree_->make(path) = std::move(copy);
}
void Json::set_bool(std::string_view path, bool value) {
  tree_->make(path) = value;
}
void Json::set_integer(std::string_view path, std::int64_t value) {
  tree_->make(path) = value;
}

void Json::append(std::string_view path, const Json& element) {
  Node copy = element.tree_->root;
  make_list(path);
  tree_->make(path).push_back(std::move(copy));
}

void Json::make_list(std::string_view path) {
  Node& node = tree_->make(path);
  if (!node.is_array()) node = Node::array();
}

bool Json::has(std::string_view path) const {
  return tree_->find(path) != nullptr;
}

bool Json::is_null(std::string_view path) const {
  const Node* node = tree_->find(path);
  if (node == nullptr) throw InputError(std::string(path) + ": missing");
  return node->is_null();
}

double Json::number(std::string_view path) const {
  return tree_->get<double>(
      path, [](const Node& node) { return node.is_number(); }, "a number");
}

std::int64_t Json::integer(std::string_view path) const {
  return tree_->get<std::int64_t>(
      path, [](const Node& node) { return node.is_number_integer(); }, "an integer");
}

std::string Json::text(std::string_view path) const {
  return tree_->get<std::string>(
      path, [](const Node& node) { return node.is_string(); }, "a text");
}

std::vector<double> Json::numbers(std::string_view path) const {
  const auto fits = [](const Node& node) {
    return node.is_array() &&
           std::all_of(node.begin(), node.end(), [](const Node& item) { return item.is_number(); });
  };
  return tree_->get<std::vector<double>>(path, fits, "a list of numbers");
}

std::vector<Json> Json::list(std::string_view path) const {
  const Node* node = tree_->find(path);
  if (node == nullptr) throw InputError(std::string(path) + ": missing");
  if (!node->is_array()) throw InputError(std::string(path) + ": must be a list");
  std::vector<Json> elements(node->size());
  for (std::size_t i = 0; i < elements.size(); ++i) elements[i].tree_->root = (*node)[i];
  return elements;
}

std::string Json::dump(int indent) const {
  // A text that is not UTF-8 (a path, say) must not cost the user the summary.
  return tree_->root.dump(indent, ' ', false, Node::error_handler_t::replace);
}

void Json::write(const std::filesystem::path& path) const {
  write_text_file(path, dump() + '\n');
}

}  // namespace tlsph
