// One routing in full, solved in each of some grasps: what `show` prints and pages draw.
#pragma once

#include "catalog/catalogue.hpp"
#include "causes/model.hpp"
#include "core/grasp.hpp"
#include "core/routing.hpp"
#include "core/tension.hpp"
#include "reports/show_report.hpp"

namespace reeve::cli {

ShowReport shown_routing(const Routing& routing, const Model& model, const GraspSet& grasps,
                         Direction direction, const Catalogue& catalogue);

}  // namespace reeve::cli
