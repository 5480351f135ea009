#include "tlsph/io/json.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>

#include "tlsph/core/error.hpp"
#include "tlsph/core/text.hpp"
#include "tlsph/io/files.hpp"

namespace tlsph {

using Node = nlohmann::ordered_json;

struct Json::Tree {
  Node root = Node::object();

  Node& make(std::string_view path) {
    Node* node = &root;
    for (const std::string_view key : split(path, '.')) {
      assert(node->is_object() || node->is_null());
      node = &(*node)[std::string(key)];
    }
    return *node;
  }

  [[nodiscard]] const Node* find(std::string_view path) const {
    const Node* node = &root;
    for (const std::string_view key : split(path, '.')) {
      if (!node->is_object()) return nullptr;
      const auto child = node->find(std::string(key));
      if (child == node->end()) return nullptr;
      node = &*child;
    }
    return node;
  }

  [[nodiscard]] const Node& at(std::string_view path) const {
    if (const Node* node = find(path)) return *node;
    throw InputError(std::string(path) + ": missing");
  }

  template <class T>
  [[nodiscard]] T get(std::string_view path, const auto& fits, const char* type) const {
    const Node& node = at(path);
    if (!std::invoke(fits, node)) throw InputError(std::string(path) + ": must be " + type);
    return node.get<T>();
  }
};

Json::Json() : tree_(std::make_unique<Tree>()) {}
Json::Json(std::nullptr_t) : tree_(std::make_unique<Tree>(Tree{nullptr})) {}
Json::Json(double value) : tree_(std::make_unique<Tree>(Tree{value})) {}
Json::Json(bool value) : tree_(std::make_unique<Tree>(Tree{value})) {}
Json::Json(std::int64_t value) : tree_(std::make_unique<Tree>(Tree{value})) {}
Json::Json(std::string_view text) : tree_(std::make_unique<Tree>(Tree{std::string(text)})) {}
Json::Json(const std::vector<double>& values) : tree_(std::make_unique<Tree>(Tree{values})) {}
Json::Json(const std::vector<std::string>& values) : tree_(std::make_unique<Tree>(Tree{values})) {}
Json::Json(const std::vector<Json>& elements) : Json() {
  tree_->root = Node::array();
  for (const Json& element : elements) tree_->root.push_back(element.tree_->root);
}
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

void Json::set(std::string_view path, Json value) {
  tree_->make(path) = std::move(value.tree_->root);
}

bool Json::has(std::string_view path) const {
  return tree_->find(path) != nullptr;
}

bool Json::is_null(std::string_view path) const {
  return tree_->at(path).is_null();
}

double Json::number(std::string_view path) const {
  return tree_->get<double>(path, &Node::is_number, "a number");
}

std::int64_t Json::integer(std::string_view path) const {
  return tree_->get<std::int64_t>(path, &Node::is_number_integer, "an integer");
}

std::string Json::text(std::string_view path) const {
  return tree_->get<std::string>(path, &Node::is_string, "a text");
}

std::vector<double> Json::numbers(std::string_view path) const {
  const auto fits = [](const Node& node) {
    return node.is_array() && std::ranges::all_of(node, &Node::is_number);
  };
  return tree_->get<std::vector<double>>(path, fits, "a list of numbers");
}

std::vector<Json> Json::list(std::string_view path) const {
  std::vector<Json> elements;
  for (const Node& node : tree_->get<Node>(path, &Node::is_array, "a list"))
    elements.emplace_back().tree_->root = node;
  return elements;
}

Json::Scalar Json::scalar() const {
  const Node& root = tree_->root;
  if (root.is_boolean()) return root.get<bool>();
  if (root.is_number_integer()) return root.get<std::int64_t>();
  if (root.is_number() && std::isfinite(root.get<double>())) return root.get<double>();
  if (root.is_string()) return root.get<std::string>();
  return {};
}

std::string Json::dump(int indent) const {
  // A text that is not UTF-8 (a path, say) must not cost the user the summary.
  return tree_->root.dump(indent, ' ', false, Node::error_handler_t::replace);
}

void Json::write(const std::filesystem::path& path) const {
  write_text_file(path, dump() + '\n');
}

}  // namespace tlsph
