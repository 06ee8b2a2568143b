// Laws that gain, and the price of their description. The evidence of a law is its gain less
// ln(n)/2 for each of its parameters less its price, in nats: the logarithm of how many such sites
// and covariates there are, and more for bent laws, for the place of a reading in the file, and for
// what some
// runs do by themselves.
#pragma once

#include <compare>
#include <vector>

#include "causes/cause.hpp"
#include "diagnosis/search/law_columns.hpp"

namespace reeve::diagnosis {

struct ScreenedLaw {
  Effect effect;  // with values to start a fit from; a zero crossing of its own is free
  double price = 0;
  double gain = 0;  // of log-likelihood, to first order
  double evidence = 0;
};

// Laws of a lever that share it differ in their form alone.
struct LawKind {
  enum class What : std::uint8_t { constant, of_part, straight, bent, product };
  What what = What::constant;
  std::size_t x = 0, y = 0;  // covariates

  auto operator<=>(const LawKind&) const = default;
};

// A law at a lever, of no size yet.
struct LeverLaw {
  std::size_t lever = 0;
  LawKind kind;
  Term term;
  double price = 0;  // beside that of the lever
};

class FoundLaws {
 public:
  explicit FoundLaws(const LawColumns& columns);

  LeverLaw law(std::size_t lever, const RowLaw& of) const;
  // The constant that so many of all runs have in common, whichever they are.
  LeverLaw law_of_runs(std::size_t lever, std::size_t size, std::size_t runs) const;
  // An offset in proportion to the n-th of so many tensions.
  LeverLaw law_of_tension(std::size_t lever, const Covariate& tension, std::size_t n,
                          std::size_t tensions) const;

  // Keeps it if it is possible, and has evidence.
  void keep(const LeverLaw& law, double gain, std::vector<double> values,
            const std::vector<double>& crossing = {});
  // Evidence of a bent law of this gain with so many parameters.
  double bent_evidence(std::size_t lever, std::size_t c, double gain, int parameters) const;

  // The most evident first, at most so many, of different levers or kinds. A law that follows
  // something is followed by the same law without it.
  std::vector<ScreenedLaw> best(std::size_t most) const;

 private:
  struct Found {
    ScreenedLaw law;
    std::size_t lever = 0;
    LawKind kind;
  };

  double price(const Lever& lever) const;
  double price_of(const Lever& lever, std::size_t c) const;

  const LawColumns& columns_;
  double parameter_price_;
  std::array<double, 3> levers_of_breadth_{};
  std::vector<Found> found_;
};

}  // namespace reeve::diagnosis
