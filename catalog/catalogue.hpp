// The catalogue of known routings: one TOML file each, so that adding a routing is adding a file.
//
//   name, word      required; the word is canonical for identical fingers
//   title, source, notes
//   like            words of the same routing for other numbers of fingers
//   held            fingers held in the grasp of [table] and [closed_form]
//   [table]         source, tension, share_percent: printed numbers, as strings
//   [[lines]]       source, mu, share_percent, read_to_percent: what a figure draws of the model
//   [closed_form]   source, strand, carriage: counts of losses { tube, bearing, sheath }
//   [[fault]]       kind = "factor" | "repeats" | "proportional" | "reversed_contact"
//   (published.hpp)
//   [[misprint]]    source, text
//
// These are the routings that explorations and rankings are compared with: the family "paper".
// Beside them, folders families/FAMILY/ hold mechanisms of the literature, likewise one file each
// (mechanisms/mechanism.hpp).
//
// Names are found whatever their case; they stand where words may stand, so none may be a word.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "catalog/catalogue_files.hpp"
#include "catalog/mechanisms/mechanism.hpp"
#include "catalog/published.hpp"
#include "core/grasp.hpp"
#include "core/routing.hpp"

namespace reeve::catalog {

inline constexpr const char* paper_family = "paper";

struct CatalogueEntry {
  std::string name;
  std::string word;
  Routing routing;
  std::string title;
  std::string source;
  std::string notes;
  std::vector<Routing> like;
  Grasp grasp;  // grasp of the published numbers
  std::optional<PublishedTable> table;
  std::vector<PublishedLines> lines;
  std::optional<ClosedForm> closed_form;
  std::vector<Fault> faults;
  std::vector<Misprint> misprints;
  std::string file;
};

struct Catalogue {
  std::vector<CatalogueEntry> entries;  // sorted by name, TR2 before TR10
  std::vector<Mechanism> mechanisms;    // sorted by family, then by name

  const CatalogueEntry* find_name(std::string_view name) const;
  // `routing` is canonical for identical fingers.
  const CatalogueEntry* find_word(const Routing& routing) const;
  const Mechanism* find_mechanism(std::string_view name) const;
  // Finds the routing of an entry or a mechanism.
  const Routing* find_routing(std::string_view name) const;
  // The routing of that name for each number of fingers that its file has, the fewest first.
  std::vector<Routing> sizes_of(std::string_view name) const;
  // Returns the families of the mechanisms, by name.
  std::vector<std::string> families() const;
};

// Throws InputError with file, line and column.
Catalogue read_catalogue(const CatalogueFiles& files);
Catalogue read_catalogue(const std::filesystem::path& folder);

// The catalogue's name of a routing, or "". Fingers count as identical: M-2-P-1-F is TR4 too.
std::string name_of(const Catalogue& catalogue, const Routing& routing);

}  // namespace reeve::catalog
