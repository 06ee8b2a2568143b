// The floor plan, for the compiler: each folder's names stand in a namespace of its own, and a
// folder writes the names of those below it as if they were its own. Names from above or beside it
// are not found. scripts/check_layers holds the includes to the same plan.
#pragma once

namespace reeve {

namespace numerics {}
namespace core {
using namespace numerics;
}
namespace causes {
using namespace core;
using namespace numerics;
}  // namespace causes
namespace search {
using namespace causes;
using namespace core;
using namespace numerics;
}  // namespace search
namespace catalog {
using namespace causes;
using namespace core;
using namespace numerics;
}  // namespace catalog
namespace diagnosis {
using namespace causes;
using namespace core;
using namespace numerics;
}  // namespace diagnosis
namespace studies {
using namespace search;
using namespace catalog;
using namespace diagnosis;
using namespace causes;
using namespace core;
using namespace numerics;
}  // namespace studies
namespace reports {
using namespace studies;
using namespace search;
using namespace catalog;
using namespace diagnosis;
using namespace causes;
using namespace core;
using namespace numerics;
}  // namespace reports
namespace pages {
using namespace reports;
using namespace studies;
using namespace search;
using namespace catalog;
using namespace diagnosis;
using namespace causes;
using namespace core;
using namespace numerics;
}  // namespace pages
namespace cli {
using namespace pages;
using namespace reports;
using namespace studies;
using namespace search;
using namespace catalog;
using namespace diagnosis;
using namespace causes;
using namespace core;
using namespace numerics;
}  // namespace cli

}  // namespace reeve
