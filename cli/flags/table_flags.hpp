// Options for the printed columns of a list, and for the width of tables.
#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <vector>

#include "cli/inputs.hpp"
#include "reports/document/chosen_columns.hpp"
#include "reports/document/document.hpp"

namespace reeve::cli {

struct TableFlags {
  TextOption columns;
  TextOption text_width;

  void add_to(CLI::App& command, const std::string& list);

  // Throw InputError, also where the format has nothing to choose.
  ListColumns read_columns(const FormatOption& format, const std::vector<std::string>& known,
                           const std::vector<MissingColumns>& missing = {}) const;
  void require_width(const FormatOption& format) const { read_width(format); }
  // Throws InputError where it is known before the work that tables cannot be so narrow: `shortest`
  // makes the document with the shortest cells that it may come to have.
  void require_room(const FormatOption& format, const std::function<Document()>& shortest) const;

  // As `printed` of printing.hpp, within the width.
  std::string printed(const Document& document, const FormatOption& format) const;

 private:
  // Returns the width in columns of text with --format table, in pt with latex; 0: any.
  double read_width(const FormatOption& format) const;
};

}  // namespace reeve::cli
