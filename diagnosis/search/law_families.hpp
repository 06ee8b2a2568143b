// Every law that the grammar of terms can say of the data, screened to first order: a lever times a
// law of what each row records. Families of laws are each screened at all levers.
#pragma once

#include <cstddef>
#include <vector>

#include "diagnosis/search/found_laws.hpp"

namespace reeve::diagnosis {

// A lever and a covariate at which a parabola gains.
struct Bend {
  std::size_t lever = 0;
  std::size_t covariate = 0;
  double evidence = 0;  // of a bent law of that gain
};

// Screens constants, straight laws (linear, log) and products of two. Each is also screened with a
// zero crossing of its own, by the columns beside it: a gain that is right at 5 V, whatever the
// middle of the data. Returns where the covariate may bend.
std::vector<Bend> screen_straight(const LawColumns& columns, FoundLaws& found);

// Screens powers, exponentials, parabolas, hinges and steps at the most promising bends.
void screen_bent(const LawColumns& columns, std::vector<Bend> bends, FoundLaws& found);

// Screens sine and cosine of each period over each covariate.
void screen_waves(const LawColumns& columns, FoundLaws& found);

// A run stands apart only from this many, itself among them.
inline constexpr std::size_t few_runs = 4;

// Screens what one run does by itself, or some of them alike.
void screen_runs(const LawColumns& columns, FoundLaws& found);

// Screens offsets of channels in proportion to another channel's tension or to the motor's: they
// are 0 where it is, or a wrong zero would seem a part of them.
void screen_tensions(const LawColumns& columns, FoundLaws& found);

// Returns the laws of all families with the most evidence first, at most so many, of different
// sites or covariates. The problem is of some of the table's readings, all cells of each.
std::vector<ScreenedLaw> best_laws(const LawTable& table, const Problem& problem,
                                   const Forecast& at, const Projection& projection,
                                   const Eigen::VectorXd& residuals, std::size_t most);

}  // namespace reeve::diagnosis
