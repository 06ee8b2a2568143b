// The subcommands that explore, rank, size, …: their results, as the package shapes them.
#include <pybind11/stl.h>

#include "cli/api.hpp"
#include "core/error.hpp"
#include "python/module/bindings.hpp"
#include "python/module/design_columns.hpp"
#include "python/module/watched.hpp"
#include "reports/catalogue_report.hpp"
#include "reports/check_report.hpp"
#include "reports/compare_report.hpp"
#include "reports/diagnosis/diagnosis_report.hpp"
#include "reports/document/document.hpp"
#include "reports/exploration/part_words.hpp"
#include "reports/exploration/stored_ranking_report.hpp"
#include "reports/import_report.hpp"
#include "reports/rank_report.hpp"
#include "reports/show_report.hpp"
#include "reports/simulation_report.hpp"
#include "reports/sizing_report.hpp"

namespace reeve::python {
namespace {

using cli::api::Arguments;
using studies::StudySupervision;

// One that takes long. It returns its result, None where stopping left nothing, and whether it was
// interrupted.
template <typename Study>
void def_study(py::module_& module, const char* name, Study study) {
  module.def(name, [study](const Arguments& arguments, const py::object& progress) {
    return watched(progress, [&](const StudySupervision& supervision) {
      return study(arguments, supervision);
    });
  });
}

template <typename Report>
void save(const Report& report, const Arguments& arguments) {
  const py::gil_scoped_release release;
  cli::api::write(report, arguments);
}

template <typename Report>
void bind_report(py::class_<Report>& report, std::string (*json)(const Report&),
                 Document (*document)(const Report&)) {
  report.def("json", json).def("text", [document](const Report& self) {
    return reports::text(document(self));
  });
}

// Binds the common results of an exploration, however it came about.
template <typename Found>
void bind_designs(py::class_<Found>& found, const ExploreReport& (*report)(const Found&)) {
  found.def("designs", [report](const Found& self) { return design_columns(report(self).top); })
      .def("front", [report](const Found& self) { return design_columns(report(self).front); })
      .def("evaluated", [report](const Found& self) { return report(self).result.evaluated; })
      .def("fingers",
           [report](const Found& self) { return report(self).options.generator.fingers; });
}

void bind_exploration(py::module_& module) {
  py::class_<ExploreReport> report(module, "ExploreReport");
  bind_report<ExploreReport>(report, &explore_summary_json,
                             [](const ExploreReport& self) { return explore_document(self); });
  bind_designs<ExploreReport>(
      report, [](const ExploreReport& self) -> const ExploreReport& { return self; });
  report.def("save", &save<ExploreReport>).def("partial", &partial_note);
  def_study(module, "explore", &cli::api::explore);
}

void bind_merging(py::module_& module) {
  using cli::api::MergedExploration;
  py::class_<MergedExploration> report(module, "MergedExploration");
  bind_report<MergedExploration>(
      report, [](const MergedExploration& self) { return explore_summary_json(self.report); },
      [](const MergedExploration& self) { return explore_document(self.report); });
  bind_designs<MergedExploration>(
      report, [](const MergedExploration& self) -> const ExploreReport& { return self.report; });
  report.def("save", &save<MergedExploration>).def("partial", [](const MergedExploration& self) {
    return partial_note(self.report);
  });
  def_study(module, "merge", &cli::api::merge);
}

void bind_ranking(py::module_& module) {
  py::class_<RankReport> report(module, "RankReport");
  bind_report<RankReport>(report, &rank_json,
                          [](const RankReport& self) { return rank_document(self); });
  report.def("save", &save<RankReport>)
      .def("designs", [](const RankReport& self) { return design_columns(self.designs); })
      .def("call_data", [](RankReport& self, const std::string& name) {
        auto& data = self.details->distributions.data;
        if (data) data->file = name;
      });
  def_study(module, "rank", &cli::api::rank);
}

void bind_stored_ranking(py::module_& module) {
  py::class_<StoredRanking> report(module, "StoredRanking");
  bind_report<StoredRanking>(report, &stored_ranking_json, [](const StoredRanking& self) {
    return stored_ranking_document(self);
  });
  bind_designs<StoredRanking>(
      report, [](const StoredRanking& self) -> const ExploreReport& { return self.report; });
  module.def("rank_stored", &cli::api::rank_stored, py::call_guard<py::gil_scoped_release>());
}

void bind_sizing(py::module_& module) {
  py::class_<SizingReport> report(module, "SizingReport");
  bind_report<SizingReport>(report, &sizing_json,
                            [](const SizingReport& self) { return sizing_document(self); });
  report.def("save", &save<SizingReport>)
      .def("hardware_toml",
           [](const SizingReport& self, const Arguments& arguments) {
             return cli::api::hardware_toml(self, arguments);
           })
      .def("partial", [](const SizingReport& self) { return self.partial; });
  def_study(module, "size", &cli::api::size);
}

void bind_diagnosis(py::module_& module) {
  py::class_<DiagnosisReport> report(module, "DiagnosisReport");
  bind_report<DiagnosisReport>(report, &diagnosis_json, &diagnosis_document);
  report.def("save", &save<DiagnosisReport>)
      .def("answer", &diagnosis_answer)
      .def("residuals_csv", &diagnosis_residuals_csv)
      .def("model_toml", &cli::api::model_toml)
      .def("call_data",
           [](DiagnosisReport& self, const std::string& name) { self.data.file = name; });
  def_study(module, "diagnose", &cli::api::diagnose);
}

void bind_showing(py::module_& module) {
  py::class_<ShownRouting> report(module, "ShownRouting");
  bind_report<ShownRouting>(report, &show_json, &show_document);
  report.def("save", &save<ShownRouting>)
      .def("svg", [](const ShownRouting& self, std::optional<std::size_t> grasp) {
        return show_svg(self, grasp ? &self.grasps.at(*grasp) : nullptr);
      });
  module.def("show", &cli::api::show, py::call_guard<py::gil_scoped_release>());
}

void bind_quick_ones(py::module_& module) {
  py::class_<CheckReport> check(module, "CheckReport");
  bind_report<CheckReport>(check, &check_json, &check_sheet);
  module.def("check", &cli::api::check, py::call_guard<py::gil_scoped_release>());
  using cli::api::ListedCatalogue;
  py::class_<ListedCatalogue> catalogue(module, "ListedCatalogue");
  bind_report<ListedCatalogue>(
      catalogue, [](const ListedCatalogue& self) { return catalogue_json(self.mechanisms); },
      [](const ListedCatalogue& self) { return catalogue_sheet(self.mechanisms); });
  catalogue.def("save", &save<ListedCatalogue>);
  module.def("catalogue", &cli::api::catalogue, py::call_guard<py::gil_scoped_release>());
  py::class_<CompareReport> comparison(module, "CompareReport");
  bind_report<CompareReport>(comparison, &compare_json, &compare_sheet);
  comparison.def("save", &save<CompareReport>)
      .def("residuals_csv", &residuals_csv)
      .def("call_data",
           [](CompareReport& self, const std::string& name) { self.data.file = name; });
  module.def("compare", &cli::api::compare, py::call_guard<py::gil_scoped_release>());
  module.def("count",
             [](const Arguments& arguments) { return count_json(cli::api::count(arguments)); });
  module.def("simulate", [](const Arguments& arguments) {
    return simulation_csv(cli::api::simulate(arguments));
  });
}

void bind_power(py::module_& module) {
  py::class_<PowerReport> report(module, "PowerReport");
  bind_report<PowerReport>(report, &power_json, &power_sheet);
  def_study(module, "power", &cli::api::power);
}

void bind_import(py::module_& module) {
  using cli::api::ImportedReadings;
  py::class_<ImportedReadings> report(module, "ImportedReadings");
  bind_report<ImportedReadings>(
      report, [](const ImportedReadings& self) { return import_json(self.report); },
      [](const ImportedReadings& self) { return import_sheet(self.report); });
  report
      .def("csv",
           [](const ImportedReadings& self) { return imported_csv(self.report, self.command); })
      .def("svg", [](const ImportedReadings& self) { return log_svg(self.report); })
      .def("call_data",
           [](ImportedReadings& self, const std::string& name) { self.report.series.file = name; });
  module.def("import_log", &cli::api::import_log, py::call_guard<py::gil_scoped_release>());
}

py::list options(const std::string& subcommand) {
  py::list texts;
  for (const cli::OptionText& option : cli::api::option_texts(subcommand)) {
    texts.append(py::make_tuple(option.name, option.preset, option.meaning, option.kind));
  }
  return texts;
}

}  // namespace

void bind_commands(py::module_& module) {
  bind_exploration(module);
  bind_merging(module);
  bind_ranking(module);
  bind_stored_ranking(module);
  bind_sizing(module);
  bind_diagnosis(module);
  bind_showing(module);
  bind_quick_ones(module);
  bind_import(module);
  bind_power(module);
  module.def("options", &options,
             "Name, default, meaning and kind of a subcommand's options, as cli/api.hpp has them.");
  module.def("objective_units", &objective_units);
}

}  // namespace reeve::python
