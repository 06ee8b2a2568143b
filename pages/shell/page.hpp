// Common frame of all pages: one file of HTML that needs no other and no network.
//
// A page is readable without JavaScript: texts, tables, schematics and charts, which are figures.
// With JavaScript they can be saved (assets/page.js), and those of an exploration come alive
// (assets/live_charts.js). A program that was built with REEVE_PAGES=OFF lacks the chart library:
// its explorations stay figures and tables, and say so.
#pragma once

#include <string>

#include "reports/output/json.hpp"

namespace reeve::pages {

// A chart. Its id names the element and the file in figures/: letters, digits and '-'.
struct Figure {
  std::string id;
  std::string title;
  std::string caption;
  std::string svg;  // says in words what it shows
};

// With buttons to save it.
std::string figure_html(const Figure& figure);

// A figure in whose place the page's script draws a chart; `alt` is what that shows, in words.
struct LiveFigure {
  Figure figure;
  std::string alt;
};
std::string live_figure_html(const LiveFigure& live);

// A schematic with buttons to save it, under the file's name if it has one of its own.
std::string schematic_html(const std::string& id, const std::string& svg,
                           const std::string& file = "");

struct Page {
  std::string title;
  std::string body;    // HTML
  std::string script;  // assets that the page runs after page.js, names separated by blanks
  Json data;           // data of the script, named reeve.data there
  bool live = false;   // true if the script draws charts: the page then bears Vega and Vega-Lite
};

std::string page_html(const Page& page);

}  // namespace reeve::pages
