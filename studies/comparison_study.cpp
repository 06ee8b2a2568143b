#include "studies/comparison_study.hpp"

#include <utility>

#include "catalog/catalogue.hpp"

namespace reeve::studies {

CompareReport comparison_study(MeasuredData data, const Model& model, const Catalogue& catalogue) {
  CompareReport report;
  report.data = std::move(data);
  report.model = model;
  for (const MeasuredRouting& measured : report.data.routings) {
    report.names.push_back(name_of(catalogue, measured.routing));
  }
  report.comparison = compare(report.data, model);
  return report;
}

}  // namespace reeve::studies
