#pragma once
/// \file
/// A table of results whose columns are stated once, for CSV, JSON, the screen and Markdown:
///
///     const Table<Pilot> table = {
///         {"spacing", &Pilot::spacing, {"spacing [m]", ">12.5g"}},
///         {"steps", &Pilot::steps},
///     };
///     write_text_file(path, table.csv(pilots));
///     json.set("pilots", table.json(pilots));

#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tlsph/io/json.hpp"

namespace tlsph {

/// `screen` stands for Markdown too.
enum class Medium { csv, json, screen };

/// How a column looks on the screen and in Markdown.
struct Screen {
  std::string heading;
  /// Blanks before the column, `<` or `>` for its alignment, its least width, and the fmt format of
  /// its numbers: "  >12.3e". Empty: the column is in files only.
  std::string layout;
  std::string (*words)(double) = nullptr;  ///< writes numbers in place of the format
};

/// What is null in JSON is an empty field in CSV and `-` on the screen; CSV has bools as 0 and 1
/// and no lists: their fields are empty.
template <class Row>
struct Column {
  using Value = std::function<Json(const Row&)>;
  Column(std::string in_files, Value of_row, Screen on_screen = {},
         std::optional<Medium> alone = {})
      : name(std::move(in_files)),
        value(std::move(of_row)),
        screen(std::move(on_screen)),
        only(alone) {}
  Column(std::string in_files, Value of_row, Medium alone)
      : Column(std::move(in_files), std::move(of_row), {}, alone) {}

  [[nodiscard]] bool is_in(Medium medium) const {
    if (medium == Medium::screen) return !screen.layout.empty();
    return !name.empty() && only.value_or(medium) == medium;
  }

  std::string name;  ///< a dot makes an object of JSON, as in Json; empty: in no file
  Value value;       ///< a member of the row, or a function of it
  Screen screen;
  std::optional<Medium> only;  ///< the kind of files it is in; both if empty
};

/// The cells of a table for one medium.
struct TableCells {
  std::vector<std::string> names;
  std::vector<Screen> screens;
  std::vector<std::vector<Json>> rows;

  [[nodiscard]] std::string csv() const;
  [[nodiscard]] std::vector<Json> json() const;
  [[nodiscard]] std::vector<std::string> lines() const;
  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::string markdown() const;
};

template <class Row>
class Table {
 public:
  using Rows = std::vector<Row>;
  Table(std::initializer_list<Column<Row>> columns) : columns_(columns) {}

  void add(Column<Row> column) { columns_.push_back(std::move(column)); }
  /// The columns of both tables.
  [[nodiscard]] Table operator+(const Table& other) const {
    Table sum = *this;
    for (const Column<Row>& column : other.columns_) sum.add(column);
    return sum;
  }
  /// The same columns for rows of which `part` is the row of this table.
  template <class Whole>
  [[nodiscard]] Table<Whole> of(Row Whole::*part) const {
    Table<Whole> whole = {};
    for (const auto& [name, value, screen, only] : columns_)
      whole.add({name, [value = value, part](const Whole& row) { return value(row.*part); }, screen,
                 only});
    return whole;
  }

  /// A line of names, then a line a row.
  [[nodiscard]] std::string csv(const Rows& rows) const { return cells(rows, Medium::csv).csv(); }
  /// An object a row.
  [[nodiscard]] std::vector<Json> json(const Rows& rows) const {
    return cells(rows, Medium::json).json();
  }
  /// A line of headings, then a line a row, without line ends. Columns are aligned, and wider than
  /// their layout says where a cell needs it.
  [[nodiscard]] std::vector<std::string> lines(const Rows& rows) const {
    return cells(rows, Medium::screen).lines();
  }
  /// These lines with their ends.
  [[nodiscard]] std::string text(const Rows& rows) const {
    return cells(rows, Medium::screen).text();
  }
  [[nodiscard]] std::string markdown(const Rows& rows) const {
    return cells(rows, Medium::screen).markdown();
  }

 private:
  TableCells cells(const Rows& rows, Medium medium) const {
    TableCells cells{{}, {}, std::vector<std::vector<Json>>(rows.size())};
    for (const Column<Row>& column : columns_) {
      if (!column.is_in(medium)) continue;
      cells.names.push_back(column.name);
      cells.screens.push_back(column.screen);
      for (std::size_t k = 0; k < rows.size(); ++k) cells.rows[k].push_back(column.value(rows[k]));
    }
    return cells;
  }

  std::vector<Column<Row>> columns_;
};

}  // namespace tlsph
