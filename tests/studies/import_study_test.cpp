#include "studies/import_study.hpp"

#include <gtest/gtest.h>

#include "core/notation.hpp"
#include "tests/support/input_error.hpp"

namespace reeve {
namespace {

// One run of a log that says neither routing nor grasp.
std::string import_error(const std::optional<std::string>& routing) {
  LoggedSeries series;
  series.labels.resize(1);
  series.label = {0};
  series.lines = {2};
  ImportLabels given;
  given.routing = routing;
  return testing::input_error([&] {
    import_study(series, given, {}, [](const std::string& word) { return parse_routing(word); });
  });
}

TEST(ImportStudy, NeedsARoutingFromTheLogOrGiven) {
  EXPECT_NE(import_error({}).find("a routing such as M-1-T-2-F, in a column of the log or given"),
            std::string::npos)
      << import_error({});
}

TEST(ImportStudy, NeedsARoutingThatAMotorPulls) {
  EXPECT_NE(import_error("F-1-F").find("F-1-F"), std::string::npos) << import_error("F-1-F");
}

}  // namespace
}  // namespace reeve
