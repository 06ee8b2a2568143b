// What all pages have in common: one file of HTML that needs no other and no network.
//
// A page is readable without JavaScript: texts, tables, schematics, and every chart as a static
// picture (chart_engine.hpp), which is also what is printed. With JavaScript the charts come alive
// and can be saved (assets/page.js).
#pragma once

#include <string>
#include <vector>

#include "reports/json.hpp"

namespace reeve {

// A chart. Its id names the element and the file in figures/: letters, digits and '-'.
struct Figure {
  std::string id;
  std::string title;
  std::string caption;
  std::string alt;  // what the picture shows, in words
  // Vega-Lite, without config and background; its data inline. null: the page's script draws it.
  Json spec;
  std::string svg;  // the static picture
};

// Draws the static picture too: of `spec`, or of what stands for it where that would be too much.
Figure figure(Figure without_picture);
Figure figure(Figure without_picture, const Json& static_spec);

std::string figure_html(const Figure& figure);

// A schematic with buttons to save it.
std::string schematic_html(const std::string& id, const std::string& svg);

struct Page {
  std::string title;
  std::string body;    // HTML
  std::string script;  // assets that the page runs after page.js, names separated by blanks
  Json data;           // what that script finds as reeve.data
};

std::string page_html(const Page& page);

}  // namespace reeve
