// The floor plan, for the compiler: each folder's names stand in a namespace of its own, and a
// folder writes the names of those below it as if they were its own. Names from above or beside it
// are not found. A folder opens the floor below, which opens the next. scripts/check_layers holds
// the includes to the same plan.
#pragma once

namespace reeve {

namespace numerics {}
namespace mpi {
using namespace numerics;
}  // namespace mpi
namespace core {
using namespace numerics;
}  // namespace core
namespace causes {
using namespace core;
}  // namespace causes
namespace readings {
using namespace core;
}  // namespace readings
namespace drawing {
using namespace core;
}  // namespace drawing
namespace search {
using namespace causes;
}  // namespace search
namespace sizing {
using namespace search;
}  // namespace sizing
namespace store {
using namespace search;
}  // namespace store
namespace catalog {
using namespace causes;
}  // namespace catalog
namespace diagnosis {
using namespace readings;
using namespace causes;
}  // namespace diagnosis
namespace studies {
using namespace sizing;
using namespace store;
using namespace catalog;
using namespace diagnosis;
}  // namespace studies
namespace reports {
using namespace drawing;
using namespace studies;
}  // namespace reports
namespace pages {
using namespace reports;
}  // namespace pages
namespace cli {
using namespace pages;
}  // namespace cli

}  // namespace reeve
